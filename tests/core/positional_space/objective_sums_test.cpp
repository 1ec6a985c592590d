#include "positional_space/objective_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/errors.h"
#include "support/meshes.h"
#include "support/scenes/small_profiles.h"

namespace vantage {
namespace {

const double kBreakdown = radians(60.0);
constexpr double kOffset = 0.05;  // in front of the surface that sources lie on [mm]
constexpr AccumulationOptions kOptions{.keepSightings = true, .surfaceOffset = kOffset};

// The ranging ray of a pose through p among all there are, by looking at every one: none when even the nearest passes
// farther away than its neighbours do from it.
std::optional<RangingRay> nearestRay(const RayGrid& rays, const Pose& pose, const Vec3& p) {
  double best = 1e9;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double distance = (p - pose * rays.ray(i).origin).cross(Vec3(pose.linear() * rays.ray(i).direction)).norm();
    if (distance < best) std::tie(best, nearest) = std::pair(distance, i);
  }
  const Vec3 local = pose.inverse() * p;
  const int row = static_cast<int>(nearest) / rays.columns();
  const int column = static_cast<int>(nearest) % rays.columns();
  const double spacing = rays.spacingAt(local, {static_cast<double>(row), static_cast<double>(column)});
  if (best > 0.7 * spacing) return std::nullopt;
  return RangingRay{pose * rays.ray(nearest).origin, pose.linear() * rays.ray(nearest).direction};
}

// What a position sees of a source, without positional space.
double exactConfidence(const ScannerProfile& profile, const Pose& pose, const ObservationSource& source,
                       const RayCaster& obstacles) {
  const auto where = profile.rays->locate(pose.inverse() * source.centre);
  if (!where) return 0.0;
  const RangingRay ray = profile.rays->rayAt(*where);
  const double cosine = -(pose.linear() * ray.direction).dot(source.normal);
  const Vec3 from = source.centre + kOffset * source.normal;
  if (cosine < std::cos(kBreakdown) || obstacles.occluded(from, pose * ray.origin)) return 0.0;
  const auto receivers = profile.rays->receivers(profile.rays->nearest(*where));
  const bool seen = receivers.empty() || std::any_of(receivers.begin(), receivers.end(), [&](const Vec3& r) {
                      return (pose * r - source.centre).dot(source.normal) > 0.0 && !obstacles.occluded(from, pose * r);
                    });
  return seen ? cosine : 0.0;
}

TEST(ObjectiveSums, ImageProductEqualsCountingTheSightingsInEveryImage) {
  const auto sources = testing::scatteredSources(200);
  for (const ScannerProfile& profile : testing::everyKind()) {
    const ScannerImages images = computeScannerImages(profile);
    const PositionalImage image = accumulate(sources, RayCaster(Mesh{}), images, kBreakdown, kOptions);
    const auto sums = intersect(image, images);
    for (int position = 0; position < images.positions(); position += 4) {
      const auto occupied = images.image(position);
      double sum = 0.0;
      for (std::size_t s = 0; s < sources.size(); ++s)
        for (const Sighting& sighting : image.sightingsOf(s))
          if (std::binary_search(occupied.begin(), occupied.end(), sighting.cell))
            sum += sources[s].weight * static_cast<double>(sighting.confidence);
      EXPECT_NEAR(sums[static_cast<std::size_t>(position)], sum, 1e-4);
    }
  }
}

TEST(ObjectiveSums, ImageProductEqualsCountingCollinearRaysOneByOne) {
  // Where no scanner's field of view ends.
  const auto sources = testing::scatteredSources(100, 60.0, 50.0);
  for (const ScannerProfile& profile : testing::everyKind()) {
    const ScannerImages images = computeScannerImages(profile);
    const auto sums = intersect(accumulate(sources, RayCaster(Mesh{}), images, kBreakdown), images);
    double counted = 0.0;
    double difference = 0.0;
    for (int position = 0; position < images.positions(); position += 11) {
      const Pose& pose = profile.workspace.poses[static_cast<std::size_t>(position)];
      // The nearest ray passes up to half a spacing aside: its angle differs by up to 0.4 degrees, which decides for
      // the few sources at the breakdown angle. They may count or not.
      double least = 0.0;
      double most = 0.0;
      for (const ObservationSource& source : sources) {
        const auto ray = nearestRay(*profile.rays, pose, source.centre);
        if (!ray) continue;
        const double cosine = -ray->direction.dot(source.normal);
        if (cosine >= std::cos(kBreakdown - radians(0.4))) least += source.weight * cosine;
        if (cosine >= std::cos(kBreakdown + radians(0.4))) most += source.weight * cosine;
      }
      const double sum = sums[static_cast<std::size_t>(position)];
      counted += least;
      difference += std::max({0.0, least - sum, sum - most});
    }
    EXPECT_GT(counted, 10.0);
    // Where positions share direction cells (the tilt of 70 degrees) a source near the border of a surface cell may be
    // counted in neither cell or in both.
    EXPECT_LT(difference, 0.03 * counted) << profile.type << " with " << profile.workspace.size() << " positions";
  }
}

TEST(ObjectiveSums, AgreeWithVisibilityTestedForEveryPosition) {
  // Half a sphere with a ball in front of it, so that much is hidden.
  Mesh half = testing::makeSphere(70.0, 20, Vec3(0, 0, 150));
  std::erase_if(half.triangles, [&](const Triangle& t) { return triangleCentre(half, t).x() < 0.0; });
  const Mesh model = testing::joined(half, testing::makeSphere(25.0, 12, Vec3(105, 20, 160)));
  const RayCaster obstacles(model);
  const auto sources = testing::sourcesOf(model);
  for (const ScannerProfile& profile : testing::everyKind()) {
    const ScannerImages images = computeScannerImages(profile);
    const auto sums = intersect(accumulate(sources, obstacles, images, kBreakdown, kOptions), images);
    double difference = 0.0;
    double exact = 0.0;
    for (std::size_t i = 0; i < sums.size(); i += 5) {
      double sum = 0.0;
      for (const ObservationSource& source : sources)
        sum += source.weight * exactConfidence(profile, profile.workspace.poses[i], source, obstacles);
      exact += sum;
      difference += std::abs(sum - sums[i]);
    }
    // One position per cell: only what is within rounding of a border differs. On the sphere, cells near the poles
    // are no rectangles.
    const bool sphere = images.grid().shape().surface == PositionalSpaceSurface::Sphere;
    EXPECT_LT(difference, (sphere ? 0.02 : 0.005) * exact) << profile.type << " " << profile.workspace.size();
  }
}

TEST(ObjectiveSums, ManyPositionsPerCellKeepTheSums) {
  // 900 positions share the direction cells by several; sums stay within what a share of a cell's width explains.
  const ScannerProfile profile = testing::linearStripe(900);
  const ScannerImages images = computeScannerImages(profile);
  const auto sources = testing::scatteredSources(2000);
  const RayCaster obstacles{Mesh{}};
  const auto sums = intersect(accumulate(sources, obstacles, images, kBreakdown, kOptions), images);
  double difference = 0.0;
  double exact = 0.0;
  for (std::size_t i = 0; i < sums.size(); i += 60) {
    double sum = 0.0;
    for (const ObservationSource& source : sources)
      sum += source.weight * exactConfidence(profile, profile.workspace.poses[i], source, obstacles);
    exact += sum;
    difference += std::abs(sum - sums[i]);
  }
  EXPECT_LT(difference, 0.03 * exact);
}

// Per position the sources that its image has sightings of, each with its best confidence.
std::vector<std::map<std::uint32_t, float>> sightedFrom(const PositionalImage& image, const ScannerImages& images) {
  std::vector<std::map<std::uint32_t, float>> sighted(static_cast<std::size_t>(images.positions()));
  for (std::uint32_t source = 0; source < image.sourceCount(); ++source) {
    for (const Sighting& sighting : image.sightingsOf(source)) {
      for (const int position : images.positionsOf(sighting.cell)) {
        float& best = sighted[static_cast<std::size_t>(position)][source];
        best = std::max(best, sighting.confidence);
      }
    }
  }
  return sighted;
}

TEST(ObjectiveSums, SightingsAreThoseOfSourcesThatThePositionSees) {
  const ScannerProfile profile = testing::rotatingStripe(90);
  const ScannerImages images = computeScannerImages(profile);
  const auto sources = testing::scatteredSources(150);
  const RayCaster obstacles(testing::makeSphere(40.0, 12, Vec3(0, 0, 150)));
  const auto seen = sightedFrom(accumulate(sources, obstacles, images, kBreakdown, kOptions), images);
  std::size_t agreed = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < 90; i += 3) {
    const std::map<std::uint32_t, float>& found = seen[i];
    for (std::uint32_t s = 0; s < sources.size(); ++s) {
      const double exact = exactConfidence(profile, profile.workspace.poses[i], sources[s], obstacles);
      if (exact == 0.0 && found.count(s) == 0) continue;
      ++pairs;
      if (exact > 0.0 && found.count(s) > 0 && std::abs(static_cast<double>(found.at(s)) - exact) < 0.02) ++agreed;
    }
  }
  EXPECT_GT(pairs, 500U);
  EXPECT_GT(static_cast<double>(agreed), 0.98 * static_cast<double>(pairs));
}

TEST(ObjectiveSums, RefusesAnImageOfOtherScannerImages) {
  const ScannerImages images = computeScannerImages(testing::linearStripe());
  PositionalImage image;
  image.sums.assign(3, 0);
  EXPECT_THROW((void)intersect(image, images), InvalidInput);
}

}  // namespace
}  // namespace vantage
