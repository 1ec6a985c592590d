#include "scanner/turntable_positioner.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

// Stands where it was told to, off by a little.
class ScriptedTable final : public Turntable {
 public:
  [[nodiscard]] std::string identity() const override { return "scripted table"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] TableAngle turnTo(double degrees, const Progress& /*progress*/) override {
    commanded.push_back(degrees);
    if (stopsAt) {
      angle_ = TableAngle{*stopsAt, PoseSource::Reported};
      throw DeviceError("scripted table: has stopped");
    }
    angle_ = {degrees + off, PoseSource::Reported};
    return *angle_;
  }
  [[nodiscard]] std::optional<TableAngle> angle() const override { return angle_; }
  void home(const Progress& /*progress*/) override { angle_ = TableAngle{}; }

  std::vector<double> commanded;
  double off = 0.0;
  std::optional<double> stopsAt;

 private:
  std::optional<TableAngle> angle_;
};

std::shared_ptr<ScannerProfile> profileOf(int steps) {
  auto profile = std::make_shared<ScannerProfile>();
  profile->workspace = turntable(steps);
  return profile;
}

TEST(TurntablePositioner, TurnsTheTableTheOtherWayThanTheScannerGoesAndNeverFartherThanHalfATurn) {
  const auto table = std::make_shared<ScriptedTable>();
  TurntablePositioner positioner(profileOf(36), table);
  for (const int position : {0, 1, 20, 35, 35}) static_cast<void>(positioner.moveTo(position, {}));
  ASSERT_EQ(table->commanded.size(), 5U);
  const double expected[] = {0.0, -10.0, -200.0, -350.0, -350.0};
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(std::remainder(table->commanded[i] - expected[i], 360.0), 0.0, 1e-9) << i;
    EXPECT_LE(std::abs(table->commanded[i] - table->commanded[i - 1]), 180.0 + 1e-9) << i;
  }
}

TEST(TurntablePositioner, BelievesATableThatSaysWhereItStands) {
  const auto table = std::make_shared<ScriptedTable>();
  table->off = 2.0;
  TurntablePositioner positioner(profileOf(36), table);
  const ReachedPose reached = positioner.moveTo(3, {});
  const Pose expected = Eigen::AngleAxisd(radians(30.0 - 2.0), Vec3::UnitZ()) * Pose::Identity();
  EXPECT_TRUE(reached.T_table_scanner.isApprox(expected, 1e-12));
  EXPECT_EQ(reached.knownBy, PoseSource::Reported);
}

TEST(TurntablePositioner, KnowsTheSenseAndTheRatioOfTheTable) {
  const auto table = std::make_shared<ScriptedTable>();
  const auto profile = profileOf(36);
  profile->calibration = TableCalibration{};
  profile->calibration->sense = -1;
  profile->calibration->degreesPerCommandedDegree = 0.5;
  TurntablePositioner positioner(profile, table);
  const ReachedPose reached = positioner.moveTo(3, {});
  EXPECT_NEAR(table->commanded.back(), 60.0, 1e-9);
  EXPECT_TRUE(reached.T_table_scanner.isApprox(profile->workspace.poses[3], 1e-12));
}

TEST(TurntablePositioner, TurnsOnceRoundForAScannerThatWaitsForAMove) {
  const auto table = std::make_shared<ScriptedTable>();
  TurntablePositioner positioner(profileOf(36), table, {.alwaysMoves = true});
  for (const int position : {0, 0, 1, 1}) static_cast<void>(positioner.moveTo(position, {}));
  const std::vector<double> expected{360.0, 0.0, -10.0, 350.0};
  ASSERT_EQ(table->commanded.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(table->commanded[i], expected[i], 1e-9) << i;
}

TEST(TurntablePositioner, GoesOnFromWhereTheTableWasLeft) {
  const auto table = std::make_shared<ScriptedTable>();
  table->home({});
  TurntablePositioner positioner(profileOf(36), table, {.stands = {.position = 9}});
  positioner.open({});
  const ReachedPose reached = positioner.moveTo(10, {});
  EXPECT_NEAR(table->commanded.back(), -10.0, 1e-9);
  EXPECT_EQ(reached.position, 10);
  EXPECT_TRUE(reached.T_table_scanner.isApprox(turntable(36).poses[10], 1e-12));
}

TEST(TurntablePositioner, TellsATableThatDoesNotKnowWhereItStandsAnglesFromPositionZero) {
  const auto table = std::make_shared<ScriptedTable>();
  TurntablePositioner positioner(profileOf(36), table, {.stands = {.position = 9}});
  positioner.open({});
  static_cast<void>(positioner.moveTo(10, {}));
  EXPECT_NEAR(std::remainder(table->commanded.back() + 100.0, 360.0), 0.0, 1e-9);
}

// The poses stay those of the table's count: they say where a scan is expected after the one that showed the slip.
TEST(TurntablePositioner, GoesToPositionsFromWhereAScanHasShownItToStand) {
  const auto table = std::make_shared<ScriptedTable>();
  table->home({});
  TurntablePositioner positioner(profileOf(36), table);
  positioner.open({});
  static_cast<void>(positioner.moveTo(3, {}));
  positioner.standsFarther(radians(20.0));
  const ReachedPose there = positioner.moveTo(5, {});
  EXPECT_NEAR(table->commanded.back(), -30.0, 1e-9);
  EXPECT_TRUE(there.T_table_scanner.isApprox(turntable(36).poses[3], 1e-12));
  EXPECT_EQ(there.position, 5);
}

TEST(TurntablePositioner, GoesOnFromWhereScansHaveShownTheTableToStand) {
  const auto table = std::make_shared<ScriptedTable>();
  table->home({});
  TurntablePositioner positioner(profileOf(36), table,
                                 {.stands = {.position = 9, .counted = radians(-20.0), .farther = radians(20.0)}});
  positioner.open({});
  const ReachedPose there = positioner.moveTo(10, {});
  EXPECT_NEAR(table->commanded.back(), -10.0, 1e-9);
  EXPECT_TRUE(there.T_table_scanner.isApprox(turntable(36).poses[8], 1e-12));
}

TEST(TurntablePositioner, SaysAfterAFailureWhereTheTableSaysItIs) {
  const auto table = std::make_shared<ScriptedTable>();
  table->home({});
  TurntablePositioner positioner(profileOf(36), table, {.stands = {.position = 2}});
  positioner.open({});
  static_cast<void>(positioner.moveTo(3, {}));
  table->stopsAt = -43.0;
  EXPECT_THROW(static_cast<void>(positioner.moveTo(9, {})), DeviceError);
  const auto here = positioner.where();
  ASSERT_TRUE(here);
  EXPECT_EQ(here->position, 6);
  const Pose expected = Eigen::AngleAxisd(radians(63.0), Vec3::UnitZ()) * Pose::Identity();
  EXPECT_TRUE(here->T_table_scanner.isApprox(expected, 1e-12));
}

TEST(TurntablePositioner, RefusesAPositionThatThereIsNot) {
  TurntablePositioner positioner(profileOf(36), std::make_shared<ScriptedTable>());
  EXPECT_THROW(static_cast<void>(positioner.moveTo(36, {})), DeviceError);
}

}  // namespace
}  // namespace vantage
