#include "scanner/simulated_scanner.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <memory>
#include <vector>

#include "base/errors.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeSphere;

// Parallel rays along -x, 1 mm apart, over a square of 60 mm about (300, 0, 150); four positions.
ScannerProfile parallelProfile(const ReceiverOffsets& receivers = {}) {
  ScannerProfile profile;
  profile.rays = std::make_shared<const RayGrid>(makeRays(LinearStripe{Vec3(300, 0, 150), 60, 61, 61, 60}, receivers));
  profile.minRange = 10.0;
  profile.maxRange = 1000.0;
  profile.workspace = turntable(4);
  return profile;
}

// A wall of one square millimetre cells facing the scanner, its front at x.
Mesh wallAt(double x, double minY = -40, double maxY = 40) {
  return makeBox(Vec3(x - 5, minY, 100), Vec3(x, maxY, 200));
}

RangeImage scanOnce(const Mesh& object, const ScannerProfile& profile, const SimulationOptions& options = {},
                    int threads = 1) {
  SimulatedScanner scanner(object, std::make_shared<const ScannerProfile>(profile), options);
  return scanner.scan(0, Progress({}, {}, threads));
}

std::vector<std::uint32_t> bytes(const RangeImage& image) {
  std::vector<std::uint32_t> result;
  for (const float r : image.range) result.push_back(std::bit_cast<std::uint32_t>(r));
  return result;
}

TEST(SimulatedScanner, MeasuresTheDistanceToAWall) {
  const RangeImage image = scanOnce(wallAt(50), parallelProfile());
  EXPECT_EQ(image.sampleCount(), image.range.size());
  for (const float r : image.range) EXPECT_FLOAT_EQ(r, 250.0F);
  EXPECT_EQ(image.position, 0);
  EXPECT_TRUE(image.T_object_scanner.isApprox(Pose::Identity()));
}

// The mesh of a sphere lies inside of it by at most r (1 - cos(pi / 2 rings)): 7e-4 mm here.
TEST(SimulatedScanner, SamplesOfASphereLieOnIt) {
  const Vec3 centre(0, 0, 150);
  const RangeImage image = scanOnce(makeSphere(25.0, 300, centre), parallelProfile());
  EXPECT_GT(image.sampleCount(), 1000U);
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) {
      EXPECT_NEAR((image.point(i) - centre).norm(), 25.0, 1e-3);
    }
}

TEST(SimulatedScanner, NothingSteeperThanTheBreakdownAngleIsSampled) {
  const Vec3 centre(0, 0, 150);
  ScannerProfile profile = parallelProfile();
  for (const double angle : {30.0, 60.0}) {
    profile.breakdownAngle = radians(angle);
    const RangeImage image = scanOnce(makeSphere(25.0, 200, centre), profile);
    for (std::size_t i = 0; i < image.range.size(); ++i) {
      const Vec3 start = image.rays->ray(i).origin;
      const double off = std::hypot(start.y(), start.z() - 150.0) / 25.0;  // sine of the angle of incidence
      // A facet leans up to a degree off the sphere.
      if (off < std::sin(radians(angle - 1.0))) {
        EXPECT_TRUE(image.valid(i));
      }
      if (off > std::sin(radians(angle + 1.0))) {
        EXPECT_FALSE(image.valid(i));
      }
    }
  }
}

TEST(SimulatedScanner, RangeLimitsCutSamplesOff) {
  ScannerProfile profile = parallelProfile();
  profile.maxRange = 249.0;
  EXPECT_EQ(scanOnce(wallAt(50), profile).sampleCount(), 0U);
  profile.maxRange = 251.0;
  EXPECT_EQ(scanOnce(wallAt(50), profile).sampleCount(), 61U * 61U);
  profile.minRange = 250.5;
  EXPECT_EQ(scanOnce(wallAt(50), profile).sampleCount(), 0U);
}

// The receiver is 100 mm to the right (+y) of every ray's head; a post between it and the wall shades part of the wall.
// Similar triangles: the line from (0, y) to (300, y + 100) passes x = 150 at y + 50, the post covers [35, 45] there,
// so the wall is hidden where y is in (-15, -5), and seen to both sides of it. The post itself stands beside the rays.
TEST(SimulatedScanner, ASampleNeedsALineOfSightToAReceiver) {
  const Mesh scene = joined(wallAt(0, -40, 30), makeBox(Vec3(149.9, 35, 100), Vec3(150, 45, 200)));
  const RangeImage image = scanOnce(scene, parallelProfile({Vec3(100, 0, 0)}));
  for (int c = 0; c < 61; ++c) {
    const double y = c - 30.0;
    const std::size_t i = image.rays->index(30, c);
    const bool hidden = y > -14.5 && y < -5.5;
    const bool seen = y < -15.5 || (y > -4.5 && y < 29.5);
    if (hidden) {
      EXPECT_FALSE(image.valid(i)) << "y = " << y;
    }
    if (seen) {
      EXPECT_TRUE(image.valid(i)) << "y = " << y;
    }
  }
}

TEST(SimulatedScanner, OneFreeReceiverIsEnough) {
  const Mesh scene = joined(wallAt(0, -40, 30), makeBox(Vec3(149.9, 35, 100), Vec3(150, 45, 200)));
  const RangeImage image = scanOnce(scene, parallelProfile({Vec3(100, 0, 0), Vec3(0, 100, 0)}));
  for (int c = 0; c < 59; ++c) EXPECT_TRUE(image.valid(image.rays->index(30, c))) << "y = " << c - 30;
}

TEST(SimulatedScanner, AReceiverBehindTheSurfaceSeesNothing) {
  // The wall leans by 50 degrees about z; a receiver far to its back side looks along it from behind.
  const RangeImage image = scanOnce(wallAt(0), parallelProfile({Vec3(0, 0, 400)}));
  EXPECT_EQ(image.sampleCount(), 0U);
}

TEST(SimulatedScanner, ASheetIsScannedFromEitherSide) {
  Mesh sheet = testing::makeGrid(1, 1, 200.0);
  for (Vec3& v : sheet.vertices) v = Vec3(20, v.x() - 100, v.y() + 50);
  EXPECT_EQ(scanOnce(sheet, parallelProfile({Vec3(50, 0, 0)})).sampleCount(), 61U * 61U);
  for (Triangle& t : sheet.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(scanOnce(sheet, parallelProfile({Vec3(50, 0, 0)})).sampleCount(), 61U * 61U);
}

// Limits are five standard errors.
TEST(SimulatedScanner, NoiseHasTheSigmaOfTheProfile) {
  ScannerProfile profile = parallelProfile();
  profile.noise.rangeSigma = 0.2;
  const RangeImage image = scanOnce(wallAt(50), profile);
  const auto n = static_cast<double>(image.range.size());
  ASSERT_EQ(image.sampleCount(), image.range.size());
  double mean = 0.0;
  double variance = 0.0;
  for (const float r : image.range) mean += (r - 250.0) / n;
  for (const float r : image.range) variance += (r - 250.0 - mean) * (r - 250.0 - mean) / n;
  EXPECT_NEAR(mean, 0.0, 5.0 * 0.2 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(variance), 0.2, 5.0 * 0.2 / std::sqrt(2.0 * n));
}

TEST(SimulatedScanner, DropoutLosesItsShareOfTheSamples) {
  ScannerProfile profile = parallelProfile();
  profile.noise.dropout = 0.3;
  const RangeImage image = scanOnce(wallAt(50), profile);
  const auto n = static_cast<double>(image.range.size());
  EXPECT_NEAR(static_cast<double>(image.sampleCount()) / n, 0.7, 5.0 * std::sqrt(0.3 * 0.7 / n));
}

TEST(SimulatedScanner, IdealSwitchesEveryErrorOff) {
  ScannerProfile profile = parallelProfile();
  profile.noise = {.rangeSigma = 0.2, .dropout = 0.3};
  profile.mechanics = {.angleSigma = radians(1.0), .positionSigma = 1.0};
  const RangeImage image = scanOnce(wallAt(50), profile, {.ideal = true});
  for (const float r : image.range) EXPECT_FLOAT_EQ(r, 250.0F);
  const SimulatedScanner scanner(wallAt(50), std::make_shared<const ScannerProfile>(profile), {.ideal = true});
  EXPECT_TRUE(scanner.mechanicalError(5).isApprox(Pose::Identity()));
}

TEST(SimulatedScanner, TheFirstScanHasNoMechanicalErrorAndLaterOnesAddUp) {
  ScannerProfile profile = parallelProfile();
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 0.4};
  const SimulatedScanner scanner(wallAt(50), std::make_shared<const ScannerProfile>(profile), {});
  EXPECT_TRUE(scanner.mechanicalError(0).isApprox(Pose::Identity()));
  double shift = 0.0;
  double turn = 0.0;
  constexpr int kMoves = 400;
  for (int move = 1; move <= kMoves; ++move) {
    const Pose step = scanner.mechanicalError(move - 1).inverse() * scanner.mechanicalError(move);
    shift += step.translation().squaredNorm() / (2.0 * kMoves);
    turn += std::pow(Eigen::AngleAxisd(step.linear()).angle(), 2) / kMoves;
    EXPECT_NEAR(step.translation().z(), 0.0, 1e-12);
    EXPECT_NEAR(step.linear()(2, 2), 1.0, 1e-12);
  }
  EXPECT_NEAR(std::sqrt(shift), 0.4, 5.0 * 0.4 / std::sqrt(4.0 * kMoves));
  EXPECT_NEAR(std::sqrt(turn), radians(0.5), 5.0 * radians(0.5) / std::sqrt(2.0 * kMoves));
}

TEST(SimulatedScanner, ScansFromItsTrueAndReportsItsNominalPose) {
  ScannerProfile profile = parallelProfile();
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 2.0};
  SimulatedScanner scanner(makeSphere(20.0, 100, Vec3(0, 0, 150)), std::make_shared<const ScannerProfile>(profile), {});
  static_cast<void>(scanner.scan(0, {}));
  const RangeImage image = scanner.scan(1, {});
  EXPECT_TRUE(image.T_object_scanner.isApprox(profile.workspace.poses[1]));
  const Pose truth = scanner.mechanicalError(1) * image.T_object_scanner;
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) {
      EXPECT_NEAR((truth * image.point(i) - Vec3(0, 0, 150)).norm(), 20.0, 0.01);
    }
}

TEST(SimulatedScanner, SameSeedSameBytesForAnyNumberOfThreads) {
  ScannerProfile profile = parallelProfile({Vec3(60, 0, 0)});
  profile.noise = {.rangeSigma = 0.1, .dropout = 0.05};
  const Mesh object = makeSphere(25.0, 60, Vec3(0, 0, 150));
  const auto expected = bytes(scanOnce(object, profile, {.seed = 7}, 1));
  for (const int threads : {2, 4}) EXPECT_EQ(bytes(scanOnce(object, profile, {.seed = 7}, threads)), expected);
  EXPECT_NE(bytes(scanOnce(object, profile, {.seed = 8}, 1)), expected);
}

TEST(SimulatedScanner, AnInterruptedSeriesGoesOnAsIfItHadNotBeen) {
  ScannerProfile profile = parallelProfile();
  profile.noise = {.rangeSigma = 0.1, .dropout = 0.05};
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 0.4};
  const auto shared = std::make_shared<const ScannerProfile>(profile);
  const Mesh object = makeSphere(25.0, 60, Vec3(0, 0, 150));
  SimulatedScanner whole(object, shared, {});
  static_cast<void>(whole.scan(0, {}));
  static_cast<void>(whole.scan(1, {}));
  SimulatedScanner resumed(object, shared, {}, 2);
  EXPECT_EQ(bytes(resumed.scan(3, {})), bytes(whole.scan(3, {})));
}

TEST(SimulatedScanner, ACancelledScanDoesNotCount) {
  ScannerProfile profile = parallelProfile();
  profile.noise.rangeSigma = 0.1;
  const auto shared = std::make_shared<const ScannerProfile>(profile);
  SimulatedScanner scanner(wallAt(50), shared, {});
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(scanner.scan(0, Progress({}, source.get_token(), 1))), Cancelled);
  EXPECT_EQ(bytes(scanner.scan(0, {})), bytes(scanOnce(wallAt(50), profile)));
}

TEST(SimulatedScanner, RefusesAPositionThatTheWorkspaceDoesNotHave) {
  SimulatedScanner scanner(wallAt(50), std::make_shared<const ScannerProfile>(parallelProfile()), {});
  EXPECT_THROW(static_cast<void>(scanner.scan(4, {})), DeviceError);
  EXPECT_THROW(static_cast<void>(scanner.scan(-1, {})), DeviceError);
}

}  // namespace
}  // namespace vantage
