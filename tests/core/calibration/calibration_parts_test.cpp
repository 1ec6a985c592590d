#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/random.h"
#include "calibration/calibration_scans.h"
#include "calibration/commanded_turns.h"
#include "calibration/plane_fit.h"
#include "calibration/rough_axis.h"
#include "calibration/sample_motion.h"
#include "calibration/screw_fit.h"
#include "calibration/screw_motion.h"
#include "calibration/table_plane.h"
#include "calibration/turn_search.h"
#include "calibration/turning_views.h"
#include "turning_scene.h"

namespace vantage::testing {
namespace {

TEST(CommandedTurns, ARatioNearOneIsOne) {
  const std::vector<double> counts{0, 20, 45, 75, 110};
  std::vector<double> angles;
  for (const double count : counts) angles.push_back(radians(count) * 1.0002);
  const CommandedTurns turns = explainTurns(counts, angles);
  EXPECT_EQ(turns.sense, 1);
  EXPECT_EQ(turns.ratio, 1.0);
  EXPECT_FALSE(turns.slippedBefore);
}

TEST(CommandedTurns, TellsSenseRatioAndWhatIsOff) {
  const std::vector<double> counts{10, 30, 55, 85, 120};
  std::vector<double> angles;
  for (const double count : counts) angles.push_back(-radians(count) * 1.1);
  angles[3] += radians(0.3);
  const CommandedTurns turns = explainTurns(counts, angles);
  EXPECT_EQ(turns.sense, -1);
  EXPECT_NEAR(turns.ratio, 1.1, 0.005);
  EXPECT_NEAR(degrees(turns.off[3]), 0.3, 0.15);
  EXPECT_FALSE(turns.slippedBefore);
}

TEST(CommandedTurns, ASlipDoesNotChangeTheRatio) {
  const std::vector<double> counts{0, 20, 45, 75, 110, 150};
  std::vector<double> angles;
  for (std::size_t k = 0; k < counts.size(); ++k) angles.push_back(radians(counts[k] - (k >= 2 ? 10.0 : 0.0)));
  const CommandedTurns turns = explainTurns(counts, angles);
  EXPECT_EQ(turns.slippedBefore, 2U);
  EXPECT_NEAR(degrees(turns.slip), -10.0, 1e-6);
  EXPECT_NEAR(turns.ratio, 1.0, 1e-9);
}

TEST(PlaneFit, FindsThePlaneOfMostPoints) {
  Random random(5);
  const Vec3 normal = Vec3(0.1, -0.05, 1.0).normalized();
  std::vector<Vec3> points;
  for (int k = 0; k < 800; ++k) {
    const double x = 100.0 * random.uniform();
    const double y = 100.0 * random.uniform();
    points.emplace_back(x, y, (7.0 - normal.x() * x - normal.y() * y) / normal.z() + 0.05 * random.normal());
  }
  for (int k = 0; k < 500; ++k)
    points.emplace_back(100.0 * random.uniform(), 100.0 * random.uniform(), 100.0 * random.uniform());
  const auto plane = fitPlane(points, Vec3::UnitZ(), radians(20.0), 0.3);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->normal.dot(normal), 1.0, 1e-5);
  EXPECT_NEAR(plane->distance(Vec3(50, 50, (7.0 - 50 * normal.x() - 50 * normal.y()) / normal.z())), 0.0, 0.03);
  EXPECT_FALSE(fitPlane(points, Vec3::UnitX(), radians(20.0), 1e-6).value_or(PlaneFit()).count > 100);
}

TEST(PlaneFit, TwoPointsSpanNone) {
  const std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  EXPECT_FALSE(fitPlane(points, Vec3::UnitZ(), radians(20.0), 1.0));
}

TEST(ScrewMotion, APointOnTheAxisStaysAndOthersTurn) {
  const ScrewMotion motion{Vec3(1, 2, 3), Vec3::UnitZ(), {0.0, radians(90.0)}};
  EXPECT_TRUE(motion.pose(0).isApprox(Pose::Identity()));
  EXPECT_TRUE((motion.pose(1) * Vec3(1, 2, 9)).isApprox(Vec3(1, 2, 9)));
  // The object turned counter-clockwise: its frame is reached by turning back.
  EXPECT_TRUE((motion.pose(1) * Vec3(1, 3, 3)).isApprox(Vec3(2, 2, 3)));
  EXPECT_EQ(motion.poses().size(), 2U);
  EXPECT_TRUE(motion.nearestTo(Vec3(9, 9, 9)).isApprox(Vec3(1, 2, 9)));
}

TEST(ScrewMotion, VectorsAcrossAnAxisMakeAFrame) {
  const Vec3 direction = Vec3(1, 2, 3).normalized();
  const AcrossAxis across(direction);
  EXPECT_TRUE(across.first.cross(across.second).isApprox(direction));
}

TEST(RoughAxis, BeginsWithTheProfileAndTriesColumnsOfAGridThatLies) {
  const auto standing = cameraOverTable();
  EXPECT_GT(upAlongColumns(*standing->rays, Vec3(0, 0, 60)).z(), 0.8);
  const auto axes = roughAxes({}, Vec3(0, 0, 60), *standing->rays, 80.0);
  ASSERT_FALSE(axes.empty());
  EXPECT_EQ(axes.front().point, Vec3::Zero());
  EXPECT_EQ(axes.front().direction, Vec3::UnitZ());
  EXPECT_TRUE(std::all_of(axes.begin(), axes.end(), [](const RoughAxis& a) { return a.direction == Vec3::UnitZ(); }));
  // x right, y down, z forward.
  std::vector<RangingRay> rays;
  for (const double y : {-0.2, 0.2})
    for (const double x : {-0.2, 0.2}) rays.push_back({Vec3::Zero(), Vec3(x, y, 1.0).normalized()});
  const RayGrid lying(2, 2, std::move(rays), {}, 0);
  const auto others = roughAxes({}, Vec3(0, 0, 400), lying, 80.0);
  EXPECT_TRUE(std::any_of(others.begin(), others.end(),
                          [](const RoughAxis& a) { return a.direction.isApprox(-Vec3::UnitY(), 1e-9); }));
}

TEST(CalibrationAngles, GrowFromZero) {
  for (int scans = 3; scans <= 12; ++scans) {
    const auto angles = calibrationAngles(scans);
    ASSERT_EQ(angles.size(), static_cast<std::size_t>(scans));
    EXPECT_EQ(angles.front(), 0.0);
    EXPECT_GE(angles.back(), 60.0);
    EXPECT_LE(angles.back(), 200.0);
    for (std::size_t k = 2; k < angles.size(); ++k)
      EXPECT_GE(angles[k] - angles[k - 1], angles[k - 1] - angles[k - 2] - 1.0);
  }
  EXPECT_EQ(calibrationAngles(6), (std::vector<double>{0, 20, 45, 75, 110, 150}));
  EXPECT_THROW((void)calibrationAngles(2), InvalidInput);
}

class SceneOfALump : public ::testing::Test {
 protected:
  SceneOfALump() {
    scene.object = makeLump();
    scene.profile = cameraOverTable();
    scene.wall = true;
    scans = scene.scans(angles);
  }
  TurningScene scene;
  std::vector<double> angles{0, 20, 45, 75};
  std::vector<CalibrationScan> scans;
};

TEST_F(SceneOfALump, WhatIsOnTheLumpMovesAndTheTableIsStill) {
  const auto motions = sampleMotions(scans);
  double right = 0.0;
  double all = 0.0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for (std::size_t i = 0; i < motions[k].size(); ++i) {
      ASSERT_EQ(scans[k].image->valid(i), motions[k][i] != SampleMotion::None);
      if (!scans[k].image->valid(i)) continue;
      const Vec3 p = scans[k].image->point(i);
      // What the lump hides in other scans can be taken for moving.
      if (p.z() > 2.0 && (p.head<2>() - Vec2(0, 0)).norm() < 70.0) {
        ++all;
        right += motions[k][i] == SampleMotion::Moving ? 1.0 : 0.0;
      } else if (p.z() < 0.5 && p.x() > 60.0) {
        ++all;
        right += motions[k][i] == SampleMotion::Still ? 1.0 : 0.0;
      }
    }
  }
  EXPECT_GT(all, 10000.0);
  EXPECT_GT(right / all, 0.9);
}

TEST_F(SceneOfALump, RangeNoiseIsThatOfTheScanner) {
  const RangeNoiseCurve noise(*scans.front().image);
  EXPECT_NEAR(noise.median(), 0.1, 0.03);
  EXPECT_NEAR(noise.at(440.0), 0.1, 0.05);
}

TEST_F(SceneOfALump, TheTableTopIsFoundBelowTheLump) {
  const auto plane = findTablePlane(scans, sampleMotions(scans), {});
  ASSERT_TRUE(plane);
  EXPECT_GT(plane->normal.z(), 0.99999);
  EXPECT_NEAR(plane->distance(Vec3::Zero()), 0.0, 0.05);
  EXPECT_GT(tableThickness(*plane), 0.3);
}

TEST_F(SceneOfALump, SearchAndFitComeToTheTurnOfTheTable) {
  const auto motions = sampleMotions(scans);
  const TurningViews views(scans, motions, findTablePlane(scans, motions, {}), scene.profile->breakdownAngle,
                           Progress());
  EXPECT_NEAR(views.centre().z(), 42.0, 25.0);
  for (const std::size_t count : views.samples()) EXPECT_GT(count, 1000U);
  const RegistrationScale scale = scaleOf(views.views());
  const auto candidates = searchTurns(views.views(), angles, Vec3(4, -3, 0), Vec3::UnitZ(), scale, {}, Progress());
  ASSERT_FALSE(candidates.empty());
  EXPECT_NEAR(candidates.front().turnsPerCount, 1.0, 0.02);
  for (std::size_t k = 1; k < candidates.size(); ++k) EXPECT_GT(candidates[k].misfit, candidates[0].misfit);
  const ScrewFit& fit = candidates.front().fit;
  EXPECT_NEAR(degrees(fit.motion.angles[3]), 75.0, 0.5);
  EXPECT_LT(misfit(fit.links, 2.0), 0.3);
  EXPECT_EQ(fit.information.rows(), 7);
  // Nothing of a lump looks round.
  const TurningViews whole = views.withRound(fit.motion, 1.0, Progress());
  EXPECT_GE(whole.samples().front(), views.samples().front());
}

// Table and sensor that keep what they are told.
class CountingTable final : public Turntable {
 public:
  [[nodiscard]] std::string identity() const override { return "counting table"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return why; }
  [[nodiscard]] TableAngle turnTo(double degrees, const Progress& /*progress*/) override {
    told.push_back(degrees);
    return {degrees + 0.25, PoseSource::Reported};
  }
  [[nodiscard]] std::optional<TableAngle> angle() const override { return TableAngle{90.0, PoseSource::Reported}; }
  void home(const Progress& /*progress*/) override {}

  std::vector<double> told;
  std::optional<std::string> why;
};

class SameScanSensor final : public RangeSensor {
 public:
  explicit SameScanSensor(RangeImage image) : image_(std::move(image)) {}
  [[nodiscard]] std::string identity() const override { return "same scan"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] RangeImage capture(const Progress& /*progress*/) override { return image_; }

 private:
  RangeImage image_;
};

TEST_F(SceneOfALump, ScansAreTakenAtAnglesFromWhereTheTableStands) {
  CountingTable table;
  SameScanSensor sensor(*scans.front().image);
  const auto taken = takeCalibrationScans(sensor, table, angles, Progress());
  EXPECT_EQ(table.told, (std::vector<double>{90, 110, 135, 165}));
  ASSERT_EQ(taken.size(), 4U);
  EXPECT_EQ(taken[1].tableAngle, 110.25);
}

TEST_F(SceneOfALump, NothingMovesBeforeADeviceThatIsNotReady) {
  CountingTable table;
  table.why = "it is not open";
  SameScanSensor sensor(*scans.front().image);
  EXPECT_THROW((void)takeCalibrationScans(sensor, table, angles, Progress()), DeviceError);
  EXPECT_TRUE(table.told.empty());
}

}  // namespace
}  // namespace vantage::testing
