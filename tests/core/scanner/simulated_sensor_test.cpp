#include "scanner/simulated_sensor.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <memory>
#include <vector>

#include "base/errors.h"
#include "base/random.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"
#include "support/simulation.h"

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
  const Rig rig = testing::simulation(object, std::make_shared<const ScannerProfile>(profile), options);
  return scanFrom(rig, 0, Progress({}, {}, threads));
}

std::vector<std::uint32_t> bytes(const RangeImage& image) {
  std::vector<std::uint32_t> result;
  for (const float r : image.range) result.push_back(std::bit_cast<std::uint32_t>(r));
  return result;
}

TEST(SimulatedSensor, MeasuresTheDistanceToAWall) {
  const RangeImage image = scanOnce(wallAt(50), parallelProfile());
  EXPECT_EQ(image.sampleCount(), image.range.size());
  for (const float r : image.range) EXPECT_FLOAT_EQ(r, 250.0F);
  EXPECT_EQ(image.station.position, 0);
  EXPECT_TRUE(image.T_table_scanner.isApprox(Pose::Identity()));
}

// The mesh of a sphere lies inside of it by at most r (1 - cos(pi / 2 rings)): 7e-4 mm here.
TEST(SimulatedSensor, SamplesOfASphereLieOnIt) {
  const Vec3 centre(0, 0, 150);
  const RangeImage image = scanOnce(makeSphere(25.0, 300, centre), parallelProfile());
  EXPECT_GT(image.sampleCount(), 1000U);
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) {
      EXPECT_NEAR((image.point(i) - centre).norm(), 25.0, 1e-3);
    }
}

TEST(SimulatedSensor, NothingSteeperThanTheBreakdownAngleIsSampled) {
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

TEST(SimulatedSensor, RangeLimitsCutSamplesOff) {
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
TEST(SimulatedSensor, ASampleNeedsALineOfSightToAReceiver) {
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

TEST(SimulatedSensor, OneFreeReceiverIsEnough) {
  const Mesh scene = joined(wallAt(0, -40, 30), makeBox(Vec3(149.9, 35, 100), Vec3(150, 45, 200)));
  const RangeImage image = scanOnce(scene, parallelProfile({Vec3(100, 0, 0), Vec3(0, 100, 0)}));
  for (int c = 0; c < 59; ++c) EXPECT_TRUE(image.valid(image.rays->index(30, c))) << "y = " << c - 30;
}

TEST(SimulatedSensor, AReceiverBehindTheSurfaceSeesNothing) {
  // The wall leans by 50 degrees about z; a receiver far to its back side looks along it from behind.
  const RangeImage image = scanOnce(wallAt(0), parallelProfile({Vec3(0, 0, 400)}));
  EXPECT_EQ(image.sampleCount(), 0U);
}

TEST(SimulatedSensor, ASheetIsScannedFromEitherSide) {
  Mesh sheet = testing::makeGrid(1, 1, 200.0);
  for (Vec3& v : sheet.vertices) v = Vec3(20, v.x() - 100, v.y() + 50);
  EXPECT_EQ(scanOnce(sheet, parallelProfile({Vec3(50, 0, 0)})).sampleCount(), 61U * 61U);
  for (Triangle& t : sheet.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(scanOnce(sheet, parallelProfile({Vec3(50, 0, 0)})).sampleCount(), 61U * 61U);
}

// Limits are five standard errors.
TEST(SimulatedSensor, NoiseHasTheSigmaOfTheProfile) {
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

TEST(SimulatedSensor, DropoutLosesItsShareOfTheSamples) {
  ScannerProfile profile = parallelProfile();
  profile.noise.dropout = 0.3;
  const RangeImage image = scanOnce(wallAt(50), profile);
  const auto n = static_cast<double>(image.range.size());
  EXPECT_NEAR(static_cast<double>(image.sampleCount()) / n, 0.7, 5.0 * std::sqrt(0.3 * 0.7 / n));
}

TEST(SimulatedSensor, IdealSwitchesNoiseAndDropoutOff) {
  ScannerProfile profile = parallelProfile();
  profile.noise = {.rangeSigma = 0.2, .dropout = 0.3};
  const RangeImage image = scanOnce(wallAt(50), profile, {.ideal = true});
  for (const float r : image.range) EXPECT_FLOAT_EQ(r, 250.0F);
}

// The mesh of the sphere is so fine that it stands for the sphere (see SamplesOfASphereLieOnIt).
TEST(SimulatedSensor, LooksFromWhereTheTableReallyIs) {
  ScannerProfile profile = parallelProfile();
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 2.0};
  const auto shared = std::make_shared<const ScannerProfile>(profile);
  const Vec3 centre(0, 0, 150);
  const Rig rig = testing::simulation(makeSphere(20.0, 100, centre), shared);
  static_cast<void>(scanFrom(rig, 0, {}));
  const RangeImage image = scanFrom(rig, 1, {});
  EXPECT_TRUE(image.T_table_scanner.isApprox(profile.workspace.poses[1]));
  const Pose truth = SimulatedTable(shared, {}).mechanicalError(1) * image.T_table_scanner;
  ASSERT_GT(image.sampleCount(), 500U);
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) {
      EXPECT_NEAR((truth * image.point(i) - centre).norm(), 20.0, 0.01);
    }
}

// What a scan is made of, calculated beside the product from its description: the n-th scan is taken from the product
// of the errors of moves 1 to n, each a shift in y and in x and a turn, drawn in this order from its own stream; a ray
// of it draws dropout, then noise, from a stream of its own. A change of any stream would change all that was ever
// simulated.
TEST(SimulatedSensor, SimulatesTheSameScansForEver) {
  ScannerProfile profile = parallelProfile();
  profile.noise = {.rangeSigma = 0.1, .dropout = 0.05};
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 0.4};
  const SimulationOptions options{.seed = 11};
  const Rig rig = testing::simulation(wallAt(50), std::make_shared<const ScannerProfile>(profile), options);
  Pose error = Pose::Identity();
  for (std::uint64_t scan = 0; scan < 3; ++scan) {
    if (scan > 0) {
      Random random(options.seed, 0x6d65636861000000ULL + scan);
      const double y = 0.4 * random.normal();
      const double x = 0.4 * random.normal();
      const double turn = radians(0.5) * random.normal();
      error = error * Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(turn, Vec3::UnitZ());
    }
    const RangeImage image = scanFrom(rig, 0, {});
    for (std::size_t i = 0; i < image.range.size(); ++i) {
      Random random(options.seed, ((scan + 1) << 40) + i);
      const bool lost = random.uniform() < 0.05;
      ASSERT_EQ(image.valid(i), !lost) << "scan " << scan << ", ray " << i;
      if (lost) continue;
      const Vec3 origin = error * image.rays->ray(i).origin;
      const Vec3 direction = error.linear() * image.rays->ray(i).direction;
      // A float of 250 mm is exact to 1.5e-5 mm, and rays are traced in floats.
      ASSERT_NEAR(image.range[i], (50.0 - origin.x()) / direction.x() + 0.1 * random.normal(), 2e-4);
    }
  }
}

TEST(SimulatedSensor, SameSeedSameBytesForAnyNumberOfThreads) {
  ScannerProfile profile = parallelProfile({Vec3(60, 0, 0)});
  profile.noise = {.rangeSigma = 0.1, .dropout = 0.05};
  const Mesh object = makeSphere(25.0, 60, Vec3(0, 0, 150));
  const auto expected = bytes(scanOnce(object, profile, {.seed = 7}, 1));
  for (const int threads : {2, 4}) EXPECT_EQ(bytes(scanOnce(object, profile, {.seed = 7}, threads)), expected);
  EXPECT_NE(bytes(scanOnce(object, profile, {.seed = 8}, 1)), expected);
}

TEST(SimulatedSensor, AnInterruptedSeriesGoesOnAsIfItHadNotBeen) {
  ScannerProfile profile = parallelProfile();
  profile.noise = {.rangeSigma = 0.1, .dropout = 0.05};
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 0.4};
  const auto shared = std::make_shared<const ScannerProfile>(profile);
  const Mesh object = makeSphere(25.0, 60, Vec3(0, 0, 150));
  const Rig whole = testing::simulation(object, shared);
  static_cast<void>(scanFrom(whole, 0, {}));
  static_cast<void>(scanFrom(whole, 1, {}));
  const Rig resumed = testing::simulation(object, shared, {}, 2);
  EXPECT_EQ(bytes(scanFrom(resumed, 3, {})), bytes(scanFrom(whole, 3, {})));
}

TEST(SimulatedSensor, ACancelledScanDoesNotCount) {
  ScannerProfile profile = parallelProfile();
  profile.noise.rangeSigma = 0.1;
  const auto shared = std::make_shared<const ScannerProfile>(profile);
  const Rig rig = testing::simulation(wallAt(50), shared);
  static_cast<void>(rig.positioner->moveTo(0, {}));
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(rig.sensor->capture(Progress({}, source.get_token(), 1))), Cancelled);
  EXPECT_EQ(bytes(scanFrom(rig, 0, {})), bytes(scanOnce(wallAt(50), profile)));
}

TEST(SimulatedSensor, CapturesNothingBeforeItIsOpenAndTheTableStandsSomewhere) {
  const auto profile = std::make_shared<const ScannerProfile>(parallelProfile());
  const Rig rig = simulatedRig(std::make_shared<const Mesh>(wallAt(50)), profile, {});
  static_cast<void>(rig.positioner->moveTo(0, {}));
  EXPECT_TRUE(rig.sensor->notReady());
  EXPECT_THROW(static_cast<void>(rig.sensor->capture({})), DeviceError);
  rig.sensor->open({});
  EXPECT_FALSE(rig.sensor->notReady());
  EXPECT_EQ(rig.sensor->capture({}).sampleCount(), 61U * 61U);
  rig.sensor->close();
  EXPECT_TRUE(rig.sensor->notReady());
  EXPECT_THROW(static_cast<void>(testing::simulation(wallAt(50), profile).sensor->capture({})), DeviceError);
}

}  // namespace
}  // namespace vantage
