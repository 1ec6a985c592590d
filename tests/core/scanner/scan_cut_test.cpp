#include "scanner/scan_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/random.h"
#include "geometry/ray_caster.h"
#include "scanner/ray_patterns.h"
#include "scanner/sample_spacing.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeSphere;

constexpr double kPlateRadius = 140.0;

// Where a sample is in truth.
enum class Truth : std::uint8_t { Nothing, Object, Rod, Table, Wall, Flying };

// What stands before the scanner, and how it measures.
struct Scene {
  std::shared_ptr<const RayGrid> rays;
  Pose T_table_scanner = Pose::Identity();
  double sigma = 0.0;
  double dropout = 0.0;
  double flying = 0.0;  // share of the samples at an edge
  double breakdownAngle = radians(60.0);
  std::uint64_t seed = 1;
};

// A sphere on a block, a plate that the cameras see from the side, and rods: upright, leaning and lying.
Mesh makeObject() {
  return joined(joined(makeSphere(40, 40, {0, 0, 85}), makeBox({-25, -25, 0}, {25, 25, 50})),
                makeBox({-60, -62, 0}, {20, -58, 60}));
}

Mesh rodAlong(const Vec3& from, const Vec3& to, double width) {
  const Vec3 along = to - from;
  Pose T = Pose::Identity();
  T.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), along).toRotationMatrix();
  T.translation() = from;
  return transformed(makeBox({-width / 2, -width / 2, 0}, {width / 2, width / 2, along.norm()}), T);
}

Mesh makeRods(double width) {
  return joined(joined(rodAlong({0, 70, 0}, {0, 70, 140}, width), rodAlong({30, 45, 20}, {-30, 110, 120}, width)),
                rodAlong({10, 0, 110}, {60, -40, 150}, width));
}

Mesh makeTable() {
  return makeBox({-kPlateRadius, -kPlateRadius, -10}, {kPlateRadius, kPlateRadius, 0});
}

// Behind the table, and what it stands on.
Mesh makeWall() {
  return joined(makeBox({-620, -900, -500}, {-600, 900, 900}), makeBox({-600, -900, -220}, {900, 900, -200}));
}

struct Seen {
  RangeImage image;
  std::vector<Truth> truth;
  std::vector<double> height;  // of the surface above the table

  [[nodiscard]] std::size_t count(Truth what) const {
    return static_cast<std::size_t>(std::count(truth.begin(), truth.end(), what));
  }
};

Seen seen(const Scene& scene, double rodWidth = 3.0) {
  const RayCaster casters[]{RayCaster(makeObject(), RayCaster::Precision::Robust),
                            RayCaster(makeRods(rodWidth), RayCaster::Precision::Robust),
                            RayCaster(makeTable(), RayCaster::Precision::Robust),
                            RayCaster(makeWall(), RayCaster::Precision::Robust)};
  const RayGrid& rays = *scene.rays;
  Seen seen;
  seen.image.rays = scene.rays;
  seen.image.T_table_scanner = scene.T_table_scanner;
  seen.image.poseKnownBy = PoseSource::Reported;
  seen.truth.assign(rays.size(), Truth::Nothing);
  seen.height.assign(rays.size(), 0.0);
  std::vector<double> exact(rays.size(), -1.0);
  std::vector<bool> steep(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vec3 origin = scene.T_table_scanner * rays.ray(i).origin;
    const Vec3 direction = scene.T_table_scanner.linear() * rays.ray(i).direction;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto hit = casters[k].intersect(origin, direction);
      if (!hit || (exact[i] >= 0.0 && hit->distance >= exact[i])) continue;
      exact[i] = hit->distance;
      steep[i] = std::abs(hit->normal.dot(direction)) < std::cos(scene.breakdownAngle);
      seen.truth[i] = static_cast<Truth>(k + 1);
      seen.height[i] = (origin + hit->distance * direction).z();
    }
  }
  seen.image.range.assign(rays.size(), kNoSample);
  for (int r = 0; r < rays.rows(); ++r) {
    for (int c = 0; c < rays.columns(); ++c) {
      const std::size_t i = rays.index(r, c);
      Random random(scene.seed, i);
      if (exact[i] < 0.0 || steep[i] || random.uniform() < scene.dropout) {
        seen.truth[i] = Truth::Nothing;
        continue;
      }
      double range = exact[i];
      // A pixel that sees front and back measures something in between.
      const int dr = static_cast<int>(random.below(3)) - 1;
      const int dc = static_cast<int>(random.below(3)) - 1;
      const bool inside = r + dr >= 0 && r + dr < rays.rows() && c + dc >= 0 && c + dc < rays.columns();
      const double other = inside ? exact[rays.index(r + dr, c + dc)] : -1.0;
      if (other >= 0.0 && std::abs(other - range) > 15.0 && random.uniform() < scene.flying) {
        range += (0.1 + 0.8 * random.uniform()) * (other - range);
        seen.truth[i] = Truth::Flying;
      }
      seen.image.range[i] = static_cast<float>(range + scene.sigma * random.normal());
    }
  }
  return seen;
}

Scene cameraScene(int rows = 240, int columns = 320) {
  Scene scene;
  scene.rays = std::make_shared<const RayGrid>(
      makeRays(Pinhole{{450, 0, 250}, {0, 0, 60}, rows, columns, radians(52.0), radians(40.0)}, {}));
  scene.sigma = 0.5;
  scene.dropout = 0.002;
  scene.flying = 0.4;
  scene.breakdownAngle = radians(80.0);
  return scene;
}

// A laser scanner without flying samples, whose table has turned.
Scene stripeScene() {
  Scene scene;
  scene.rays =
      std::make_shared<const RayGrid>(makeRays(RotatingStripe{{400, 0, 120}, 300, 150, 200, radians(50.0)}, {}));
  scene.T_table_scanner = Pose(Eigen::AngleAxisd(radians(70.0), Vec3::UnitZ()));
  scene.sigma = 0.1;
  return scene;
}

ScanCut realCut(const Scene& scene) {
  return {{ViewingVolume{130.0, 250.0}, scene.breakdownAngle, 0.0}, cutForRealScanners()};
}

// The share of samples of a kind that are kept, of those that are high enough above the table.
double keptShare(const Seen& seen, const std::vector<CutReason>& reasons, Truth what, double above = -1e9) {
  double kept = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (seen.truth[i] != what || seen.height[i] < above) continue;
    all += 1.0;
    kept += reasons[i] == CutReason::Kept ? 1.0 : 0.0;
  }
  EXPECT_GT(all, 50.0);
  return kept / all;
}

TEST(ScanCut, CutsNothingUnlessItIsAskedTo) {
  EXPECT_TRUE(cutsNothing({}));
  EXPECT_FALSE(cutsNothing(cutForRealScanners()));
  const auto image = std::make_shared<const RangeImage>(seen(cameraScene(60, 80)).image);
  ScanCut cut = realCut(cameraScene());
  cut.options = {};
  const CutImage same = cutImage(image, cut);
  EXPECT_EQ(same.image, image);
  EXPECT_EQ(cutSamples(same.counts), 0U);
  const CutCounts counts = countsOf(cutOf(*image, cut));
  EXPECT_EQ(counts[static_cast<std::size_t>(CutReason::Kept)], image->sampleCount());
  EXPECT_EQ(cutSamples(counts), 0U);
}

TEST(ScanCut, LeavesNothingOfTableAndWall) {
  for (const Scene& scene : {cameraScene(), stripeScene()}) {
    const Seen scan = seen(scene);
    const auto reasons = cutOf(scan.image, realCut(scene));
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      const bool background = scan.truth[i] == Truth::Table || scan.truth[i] == Truth::Wall;
      ASSERT_FALSE(background && reasons[i] == CutReason::Kept) << i;
    }
  }
}

TEST(ScanCut, KeepsTheObject) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (Scene scene : {cameraScene(), stripeScene()}) {
      scene.seed = seed;
      const Seen scan = seen(scene);
      const auto reasons = cutOf(scan.image, realCut(scene));
      // Above half a spacing and four sigmas.
      EXPECT_GT(keptShare(scan, reasons, Truth::Object, 0.5 * 2.5 + 4.0 * scene.sigma), 0.995);
      RecordProperty("kept", std::to_string(keptShare(scan, reasons, Truth::Object)));
    }
  }
}

TEST(ScanCut, ThinRodsSurvive) {
  for (const double width : {2.0, 3.0, 5.0}) {
    const Seen scan = seen(cameraScene(), width);
    const auto reasons = cutOf(scan.image, realCut(cameraScene()));
    EXPECT_GT(keptShare(scan, reasons, Truth::Rod, 4.0), 0.95) << width;
  }
}

TEST(ScanCut, DropsFlyingSamples) {
  const Seen scan = seen(cameraScene());
  ScanCut cut = realCut(cameraScene());
  const auto reasons = cutOf(scan.image, cut);
  EXPECT_GT(scan.count(Truth::Flying), 300U);
  EXPECT_LT(keptShare(scan, reasons, Truth::Flying), 0.1);
  cut.options.flyingPixels = false;
  EXPECT_GT(keptShare(scan, cutOf(scan.image, cut), Truth::Flying), 2.0 * keptShare(scan, reasons, Truth::Flying));
}

// Parallel rays along -x from x = 300 at y and z of -10..10 mm, 1 mm apart; z = 0 is row 10.
RangeImage flatImage(double range = 100.0) {
  RangeImage image;
  image.rays = std::make_shared<const RayGrid>(makeRays(LinearStripe{Vec3(300, 0, 0), 20, 21, 21, 20}, {}));
  image.range.assign(image.rays->size(), static_cast<float>(range));
  image.poseKnownBy = PoseSource::Commanded;
  return image;
}

CutOptions flyingOnly() {
  CutOptions options;
  options.flyingPixels = true;
  return options;
}

CutReason reasonAt(const RangeImage& image, const CutOptions& options, int row, int column,
                   double breakdownAngle = radians(60.0)) {
  return cutOf(image, {{ViewingVolume{1000.0, 1000.0}, breakdownAngle, 0.0}, options})[image.rays->index(row, column)];
}

// Columns left of `column` lie in front, those right of it behind.
RangeImage stepImage(int column, double front, double middle, double back) {
  RangeImage image = flatImage();
  for (int r = 0; r < 21; ++r)
    for (int c = 0; c < 21; ++c)
      image.range[image.rays->index(r, c)] = static_cast<float>(c < column ? front : c > column ? back : middle);
  return image;
}

TEST(ScanCut, AFlyingSampleLiesBetweenFrontAndBack) {
  EXPECT_EQ(reasonAt(stepImage(10, 100, 150, 200), flyingOnly(), 10, 10), CutReason::Flying);
  EXPECT_EQ(reasonAt(stepImage(10, 100, 150, 200), flyingOnly(), 10, 9), CutReason::Kept);
  EXPECT_EQ(reasonAt(stepImage(10, 100, 150, 200), flyingOnly(), 10, 11), CutReason::Kept);
  EXPECT_EQ(reasonAt(stepImage(10, 200, 100, 200), flyingOnly(), 10, 10), CutReason::Kept) << "a rod before a wall";
  EXPECT_EQ(reasonAt(stepImage(10, 100, 200, 100), flyingOnly(), 10, 10), CutReason::Kept) << "the ground of a slit";
  EXPECT_EQ(reasonAt(stepImage(10, 100, 101, 200), flyingOnly(), 10, 10), CutReason::Kept) << "belongs to the front";
}

TEST(ScanCut, AWideFringeIsFlyingToo) {
  RangeImage image = stepImage(10, 100, 170, 200);
  for (int r = 0; r < 21; ++r) {
    image.range[image.rays->index(r, 10)] = static_cast<float>(150 + 7 * (r % 3));
    image.range[image.rays->index(r, 11)] = static_cast<float>(120 + 9 * (r % 2));
  }
  EXPECT_EQ(reasonAt(image, flyingOnly(), 10, 10), CutReason::Flying);
  EXPECT_EQ(reasonAt(image, flyingOnly(), 10, 11), CutReason::Flying);
}

TEST(ScanCut, SteepSurfaceUpToTheBreakdownAngleIsKept) {
  for (const double angle : {40.0, 60.0, 75.0}) {
    RangeImage image = flatImage();
    for (int r = 0; r < 21; ++r)
      for (int c = 0; c < 21; ++c) {
        Random random(5, image.rays->index(r, c));
        image.range[image.rays->index(r, c)] =
            static_cast<float>(150.0 + (c - 10) * std::tan(radians(angle)) + 0.3 * random.normal());
      }
    const ScanCut cut{{std::nullopt, radians(angle), 0.0}, cutForRealScanners()};
    EXPECT_EQ(cutSamples(countsOf(cutOf(image, cut))), 0U) << angle;
  }
}

TEST(ScanCut, DropsWhatHangsTogetherWithTooLittle) {
  RangeImage image = flatImage();
  std::fill(image.range.begin(), image.range.end(), kNoSample);
  for (int c = 0; c < 5; ++c) image.range[image.rays->index(2, c)] = 100.0F;
  for (int c = 0; c < 4; ++c) image.range[image.rays->index(8, 2 * c)] = 100.0F;
  image.range[image.rays->index(18, 18)] = 100.0F;
  CutOptions options;
  options.isolated = true;
  EXPECT_EQ(reasonAt(image, options, 18, 18), CutReason::Isolated);
  EXPECT_EQ(reasonAt(image, options, 2, 1), CutReason::Kept);
  options.smallestIsland = 5;
  EXPECT_EQ(reasonAt(image, options, 2, 1), CutReason::Kept);
  EXPECT_EQ(reasonAt(image, options, 8, 2), CutReason::Island);
  EXPECT_EQ(reasonAt(image, options, 18, 18), CutReason::Isolated);
  options.isolated = false;
  EXPECT_EQ(reasonAt(image, options, 18, 18), CutReason::Island);
  EXPECT_EQ(reasonAt(image, options, 0, 0), CutReason::NoSample);
}

TEST(ScanCut, TheVolumeStandsOnTheTableWhereTheScannerIs) {
  RangeImage image = flatImage(300.0);  // the plane x = 0
  ScanCut cut{{ViewingVolume{8.2, 6.5}, radians(60.0), 0.0}, {}};
  cut.options.volume = true;
  cut.options.tableMargin = 2.5;
  const auto at = [&](int row, int column) { return cutOf(image, cut)[image.rays->index(row, column)]; };
  const bool upwards = image.rays->ray(image.rays->index(20, 10)).origin.z() > 0.0;
  const auto row = [&](int z) { return upwards ? 10 + z : 10 - z; };
  EXPECT_EQ(at(row(0), 10), CutReason::Table);
  EXPECT_EQ(at(row(2), 10), CutReason::Table);
  EXPECT_EQ(at(row(3), 10), CutReason::Kept);
  EXPECT_EQ(at(row(6), 10), CutReason::Kept);
  EXPECT_EQ(at(row(7), 10), CutReason::Outside);
  EXPECT_EQ(at(row(3), 18), CutReason::Kept);
  EXPECT_EQ(at(row(3), 19), CutReason::Outside);
  cut.options.radiusMargin = 1.7;
  EXPECT_EQ(at(row(3), 17), CutReason::Outside);
  image.T_table_scanner.translation() = Vec3(0, 0, 4);
  EXPECT_EQ(at(row(0), 10), CutReason::Kept);
  EXPECT_EQ(at(row(3), 10), CutReason::Outside);
  image.poseKnownBy = PoseSource::Unknown;
  EXPECT_EQ(cutSamples(countsOf(cutOf(image, cut))), 0U) << "nobody knows where it stands";
  image.station.position = 3;
  EXPECT_GT(cutSamples(countsOf(cutOf(image, cut))), 0U);
}

TEST(ScanCut, TheImageTellsItsNoise) {
  for (const double sigma : {0.05, 0.5, 2.0}) {
    RangeImage image = flatImage();
    for (std::size_t i = 0; i < image.range.size(); ++i)
      image.range[i] += static_cast<float>(sigma * Random(9, i).normal());
    EXPECT_NEAR(rangeSigmaOf(image), sigma, 0.15 * sigma);
  }
  EXPECT_EQ(rangeSigmaOf(flatImage()), 0.0);
}

TEST(ScanCut, OnlyWhatIsCutIsTakenOut) {
  const Seen scan = seen(cameraScene(60, 80));
  const auto whole = std::make_shared<const RangeImage>(scan.image);
  const CutImage cut = cutImage(whole, realCut(cameraScene()));
  const auto reasons = cutOf(*whole, realCut(cameraScene()));
  EXPECT_EQ(cut.counts, countsOf(reasons));
  EXPECT_GT(cutSamples(cut.counts), 1000U);
  EXPECT_EQ(cut.image->rays, whole->rays);
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    ASSERT_EQ(cut.image->valid(i), reasons[i] == CutReason::Kept);
    if (cut.image->valid(i)) {
      ASSERT_EQ(cut.image->range[i], whole->range[i]);
    }
  }
}

TEST(ScanCut, RefusesARangeImageThatIsNone) {
  RangeImage image = flatImage();
  image.range.pop_back();
  EXPECT_THROW(static_cast<void>(cutOf(image, {{}, cutForRealScanners()})), InvalidInput);
}

TEST(ScanCut, KnowsTheSceneOfAScanner) {
  ScannerProfile profile;
  profile.viewingVolume = {70.0, 90.0};
  profile.breakdownAngle = radians(72.0);
  profile.noise.rangeSigma = 0.2;
  const CutScene scene = cutSceneOf(profile);
  EXPECT_EQ(scene.volume->radius, 70.0);
  EXPECT_EQ(scene.breakdownAngle, radians(72.0));
  EXPECT_EQ(scene.rangeSigma, 0.2);
  EXPECT_EQ(name(CutReason::Flying), "flying");
}

TEST(RaySpacing, IsTakenAtTheNearerSampleAcrossTheRay) {
  RangeImage image = flatImage();
  EXPECT_NEAR(raySpacing(image, 0, 1), 1.0, 1e-9);
  image.rays = cameraScene().rays;
  image.range.assign(image.rays->size(), 500.0F);
  image.range[1] = 250.0F;
  EXPECT_NEAR(raySpacing(image, 0, 1), raySpacing(image, 1, 2), 0.01);
  EXPECT_NEAR(2.0 * raySpacing(image, 0, 1), raySpacing(image, 2, 3), 0.05);
}

}  // namespace
}  // namespace vantage
