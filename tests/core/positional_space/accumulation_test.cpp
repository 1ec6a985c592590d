#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stop_token>

#include "base/errors.h"
#include "positional_space/objective_sums.h"
#include "positional_space/positional_image.h"
#include "support/meshes.h"
#include "support/scenes/small_profiles.h"

namespace vantage {
namespace {

const double kBreakdown = radians(60.0);

RayCaster nothing() {
  return RayCaster(Mesh{});
}

// A rectangle with its lower left corner at `corner`, spanned by two vectors.
Mesh plate(const Vec3& corner, const Vec3& a, const Vec3& b) {
  return {{corner, corner + a, corner + a + b, corner + b}, {{0, 1, 2}, {0, 2, 3}}};
}

double total(const PositionalImage& image) {
  return static_cast<double>(std::accumulate(image.sums.begin(), image.sums.end(), std::int64_t{0})) *
         PositionalImage::kUnit;
}

std::vector<ObservationSource> turned(std::vector<ObservationSource> sources, double angle) {
  const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
  for (ObservationSource& s : sources) {
    s.centre = turn * s.centre;
    s.normal = turn * s.normal;
  }
  return sources;
}

TEST(Accumulation, AFrontalSourceIsSeenOnceFromThePositionInFrontOfIt) {
  // On the axis at half height, facing the head of position 0: the ranging ray through it leaves along its normal.
  const ScannerImages images = computeScannerImages(testing::rotatingStripe(90));
  const std::vector<ObservationSource> source = {{Vec3(0, 0, 150.0), Vec3::UnitX(), 2.0}};
  const auto sums = intersect(accumulate(source, nothing(), images, kBreakdown), images);
  EXPECT_NEAR(sums[0], 2.0, 1e-4);
  // Position 10 looks from 40 degrees aside.
  EXPECT_NEAR(sums[10], 2.0 * std::cos(radians(40.0)), 1e-3);
  EXPECT_NEAR(sums[80], 2.0 * std::cos(radians(40.0)), 1e-3);
  // Beyond 60 degrees, and from behind.
  EXPECT_EQ(sums[16], 0.0);
  EXPECT_EQ(sums[45], 0.0);
}

TEST(Accumulation, AWallHidesWhatIsBehindIt) {
  const ScannerImages images = computeScannerImages(testing::linearStripe(90));
  const std::vector<ObservationSource> source = {{Vec3(0, 0, 150.0), Vec3::UnitX(), 1.0}};
  // Blocks the rays at y > 0 in front of the source, from straight ahead to 45 degrees.
  const RayCaster wall(plate(Vec3(50, -2, 100), Vec3(0, 52, 0), Vec3(0, 0, 100)));
  const auto open = intersect(accumulate(source, nothing(), images, kBreakdown), images);
  const auto hidden = intersect(accumulate(source, wall, images, kBreakdown), images);
  EXPECT_EQ(hidden[0], 0.0);
  EXPECT_EQ(hidden[5], 0.0);
  EXPECT_EQ(hidden[10], 0.0);
  for (const std::size_t free : {12U, 14U, 78U, 85U, 88U}) {
    EXPECT_GT(open[free], 0.4);
    EXPECT_EQ(hidden[free], open[free]);
  }
}

TEST(Accumulation, ABlockedReceiverHidesASource) {
  const std::vector<ObservationSource> source = {{Vec3(0, 0, 150.0), Vec3::UnitX(), 1.0}};
  // The receiver of position 0 is at (300, 60, 150), right of the head as it looks along -x. At x = 140 the plate hides
  // y from 20 to 40, where the line of sight passes at 28, but not the ray at y = 0.
  ScannerProfile profile = testing::rotatingStripe(90);
  const ScannerImages images = computeScannerImages(profile);
  const RayCaster screen(plate(Vec3(140, 20, 140), Vec3(0, 20, 0), Vec3(0, 0, 20)));
  EXPECT_NEAR(intersect(accumulate(source, nothing(), images, kBreakdown), images)[0], 1.0, 1e-4);
  EXPECT_EQ(intersect(accumulate(source, screen, images, kBreakdown), images)[0], 0.0);

  // A second receiver on the other side sees it.
  std::vector<RangingRay> rays;
  std::vector<Vec3> receivers;
  for (std::size_t i = 0; i < profile.rays->size(); ++i) {
    rays.push_back(profile.rays->ray(i));
    const Vec3 first = profile.rays->receivers(i)[0];
    receivers.push_back(first);
    receivers.push_back(2.0 * Vec3(300, 0, 150) - first);
  }
  profile.rays = std::make_shared<const RayGrid>(profile.rays->rows(), profile.rays->columns(), rays, receivers, 2);
  const ScannerImages both = computeScannerImages(profile);
  EXPECT_NEAR(intersect(accumulate(source, screen, both, kBreakdown), both)[0], 1.0, 1e-4);
}

TEST(Accumulation, ASourceOutOfRangeIsNotSeen) {
  ScannerProfile profile = testing::linearStripe(90);
  profile.minRange = 100.0;
  profile.maxRange = 310.0;
  const ScannerImages images = computeScannerImages(profile);
  // From the heads at x = 320: 300 mm to the one, 340 mm to the other.
  const std::vector<ObservationSource> near = {{Vec3(20, 0, 150.0), Vec3::UnitX(), 1.0}};
  const std::vector<ObservationSource> far = {{Vec3(-20, 0, 150.0), Vec3::UnitX(), 1.0}};
  EXPECT_NEAR(intersect(accumulate(near, nothing(), images, kBreakdown), images)[0], 1.0, 1e-3);
  EXPECT_EQ(intersect(accumulate(far, nothing(), images, kBreakdown), images)[0], 0.0);
}

TEST(Accumulation, TurningTheObjectByAStepShiftsTheSums) {
  for (const ScannerProfile& profile : {testing::rotatingStripe(90), testing::pinhole(90)}) {
    const ScannerImages images = computeScannerImages(profile);
    const auto sources = testing::scatteredSources(300);
    const auto before = intersect(accumulate(sources, nothing(), images, kBreakdown), images);
    const auto after = intersect(accumulate(turned(sources, radians(4.0)), nothing(), images, kBreakdown), images);
    // Only a ray that is within rounding of a cell's border may go to the other side.
    const double most = *std::max_element(before.begin(), before.end());
    for (std::size_t i = 0; i < 90; ++i) EXPECT_NEAR(after[(i + 1) % 90], before[i], 0.01 * most);
  }
}

TEST(Accumulation, AnyThreadCountGivesTheSameBytes) {
  const ScannerImages images = computeScannerImages(testing::pinhole(90));
  const auto sources = testing::scatteredSources(700);
  const RayCaster obstacles(testing::makeSphere(40.0, 12, Vec3(0, 0, 150)));
  AccumulationOptions options;
  options.keepSightings = true;
  const PositionalImage one = accumulate(sources, obstacles, images, kBreakdown, options);
  for (const int threads : {2, 5}) {
    const PositionalImage more =
        accumulate(sources, obstacles, images, kBreakdown, options, Progress(nullptr, {}, threads));
    EXPECT_EQ(more.sums, one.sums);
    EXPECT_EQ(more.sightingStart, one.sightingStart);
    EXPECT_EQ(more.observationRays, one.observationRays);
    EXPECT_EQ(more.linesOfSight, one.linesOfSight);
    ASSERT_EQ(more.sightings.size(), one.sightings.size());
    for (std::size_t k = 0; k < one.sightings.size(); ++k) {
      EXPECT_EQ(more.sightings[k].cell, one.sightings[k].cell);
      EXPECT_EQ(more.sightings[k].confidence, one.sightings[k].confidence);
    }
  }
}

TEST(Accumulation, SightingsAddUpToTheImage) {
  const ScannerImages images = computeScannerImages(testing::rotatingStripe(180));
  const auto sources = testing::scatteredSources(300);
  AccumulationOptions options;
  options.keepSightings = true;
  const PositionalImage image = accumulate(sources, nothing(), images, kBreakdown, options);
  ASSERT_EQ(image.sourceCount(), sources.size());
  std::vector<double> sums(images.cellCount(), 0.0);
  for (std::size_t s = 0; s < sources.size(); ++s)
    for (const Sighting& sighting : image.sightingsOf(s))
      sums[sighting.cell] += sources[s].weight * static_cast<double>(sighting.confidence);
  for (std::uint32_t cell = 0; cell < sums.size(); ++cell) EXPECT_NEAR(sums[cell], image.at(cell), 1e-4);
}

TEST(Accumulation, SourcesWithoutWeightAddNothing) {
  const ScannerImages images = computeScannerImages(testing::linearStripe());
  const std::vector<ObservationSource> source = {{Vec3(0, 0, 150.0), Vec3::Zero(), 0.0}};
  const PositionalImage image = accumulate(source, nothing(), images, kBreakdown);
  EXPECT_EQ(total(image), 0.0);
  EXPECT_EQ(image.observationRays, 0U);
}

TEST(Accumulation, RefusesWhatIsNoSource) {
  const ScannerImages images = computeScannerImages(testing::linearStripe());
  auto refused = [&](const ObservationSource& source) {
    EXPECT_THROW((void)accumulate(std::vector{source}, nothing(), images, kBreakdown), InvalidInput);
  };
  refused({Vec3(0, 0, 150.0), Vec3(1, 1, 0), 1.0});
  refused({Vec3(0, 0, 150.0), Vec3::UnitX(), -1.0});
  refused({Vec3(0, 0, std::numeric_limits<double>::quiet_NaN()), Vec3::UnitX(), 1.0});
}

TEST(Accumulation, StopsWhenAsked) {
  const ScannerImages images = computeScannerImages(testing::linearStripe());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)accumulate(testing::scatteredSources(10), nothing(), images, kBreakdown, {},
                                Progress(nullptr, stop.get_token(), 2)),
               Cancelled);
}

}  // namespace
}  // namespace vantage
