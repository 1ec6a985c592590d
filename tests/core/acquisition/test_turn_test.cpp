#include "acquisition/test_turn.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "scanner/hand_table.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

TestTurn turn(int from, int to, bool ideal) {
  const auto profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), profile, {7, ideal});
  return testTurn(rig, *profile, from, to, {}, {});
}

TEST(TestTurn, MeasuresTheTurnThatAPerfectTableMakes) {
  const TestTurn result = turn(0, 2, true);
  EXPECT_NEAR(result.expected, radians(30.0), 1e-9);
  EXPECT_NEAR(result.measured, result.expected, radians(0.1));
  EXPECT_LT(result.axisOffset, 0.2);
  EXPECT_NE(result.registration.verdict, Verdict::Failed);
  EXPECT_GT(result.samples, 500U);
}

TEST(TestTurn, FindsTheErrorThatTheMechanicsMade) {
  const auto profile = testing::smallProfile();
  const SimulationOptions options{7, false};
  const Rig rig = testing::simulation(testing::smallObject(), profile, options);
  const TestTurn result = testTurn(rig, *profile, 0, 1, {}, {});
  const SimulatedTable table(profile, options);
  const Pose truth = table.mechanicalError(1) * table.mechanicalError(0).inverse();
  const double error = std::atan2(truth.linear()(1, 0), truth.linear()(0, 0));
  // The scans are about 3 mm apart and register to a fraction of that.
  EXPECT_NEAR(result.measured - result.expected, error, radians(0.15));
}

// A scan beside the second one that is 1.8 mm, nine sigmas of the small scanner's table, off.
TEST(TestTurn, BelievesThePositionerInHowFarItMayBeOff) {
  const auto profile = testing::smallProfile();
  const auto turnOf = [&](std::optional<Mechanics> uncertainty) {
    auto sloppy = std::make_shared<ScannerProfile>(*profile);
    sloppy->workspace.poses[2] = Eigen::Translation3d(1.8, 0.0, 0.0) * sloppy->workspace.poses[2];
    Rig rig = testing::simulation(testing::smallObject(), profile, {7, true});
    const auto turn = [table = rig.positioner](int position, const Progress& progress) {
      static_cast<void>(table->moveTo(position, progress));
    };
    rig.positioner = std::make_shared<HandTable>(sloppy, turn, uncertainty);
    return testTurn(rig, *profile, 0, 2, {}, {});
  };
  EXPECT_EQ(turnOf({}).registration.verdict, Verdict::Failed);
  EXPECT_NE(turnOf(Mechanics{radians(1.0), 2.0}).registration.verdict, Verdict::Failed);
}

// The table turns farther than its profile has it, by much less than lets the scans not fit.
TEST(TestTurn, IsAsExpectedOnlyWhereTheTableWasToBe) {
  const auto profile = testing::smallProfile();
  const auto turnFartherBy = [&](double more) {
    auto sloppy = std::make_shared<ScannerProfile>(*profile);
    sloppy->workspace.poses[2] = Eigen::AngleAxisd(more, Vec3::UnitZ()) * sloppy->workspace.poses[2];
    Rig rig = testing::simulation(testing::smallObject(), profile, {7, true});
    const auto turn = [table = rig.positioner](int position, const Progress& progress) {
      static_cast<void>(table->moveTo(position, progress));
    };
    rig.positioner = std::make_shared<HandTable>(sloppy, turn, Mechanics{});
    return testTurn(rig, *profile, 0, 2, {}, {});
  };
  EXPECT_TRUE(turnFartherBy(0.0).asExpected());
  TestTurn result = turnFartherBy(0.0);
  result.errors = {radians(0.3), 0.3};
  result.measured = result.expected + radians(1.0);
  EXPECT_TRUE(result.asExpected());
  result.measured = result.expected - radians(2.0);
  EXPECT_FALSE(result.asExpected());
  result.measured = result.expected;
  result.axisOffset = 2.0;
  EXPECT_FALSE(result.asExpected());
}

TEST(TestTurn, SaysWhenTheScannerSeesNothing) {
  const auto profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::makeSphere(5, 8, {0, 0, 900}), profile, {7, true});
  EXPECT_THROW(static_cast<void>(testTurn(rig, *profile, 0, 1, {}, {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
