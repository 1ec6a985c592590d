#include "scanner/workspace.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

const Vec3 kScanner(300, 0, 150);

TEST(Workspace, PositionZeroOfATurntableIsTheIdentity) {
  EXPECT_TRUE(turntable(90).poses[0].isApprox(Pose::Identity()));
  EXPECT_EQ(turntable(90).size(), 90U);
  EXPECT_EQ(turntable(90).steps, 90);
}

// The object turns by -2 pi i / n, which is the scanner going round by +2 pi i / n.
TEST(Workspace, AQuarterTurnTakesTheScannerFromXToY) {
  const Workspace w = turntable(4);
  EXPECT_TRUE((w.poses[1] * kScanner).isApprox(Vec3(0, 300, 150)));
  EXPECT_TRUE((w.poses[2] * kScanner).isApprox(Vec3(-300, 0, 150)));
  EXPECT_TRUE((w.poses[3] * kScanner).isApprox(Vec3(0, -300, 150)));
}

TEST(Workspace, APositiveTiltRaisesTheScannerSoThatItLooksDown) {
  const Workspace w = turntableWithTilt(1, {radians(90.0), radians(-90.0), radians(30.0)}, Vec3(0, 0, 150));
  EXPECT_TRUE((w.poses[0] * kScanner).isApprox(Vec3(0, 0, 450)));
  EXPECT_TRUE((w.poses[0].linear() * -Vec3::UnitX()).isApprox(-Vec3::UnitZ()));
  EXPECT_TRUE((w.poses[1] * kScanner).isApprox(Vec3(0, 0, -150)));
  EXPECT_NEAR((w.poses[2] * kScanner).z(), 150.0 + 300.0 * 0.5, 1e-9);
  EXPECT_NEAR((w.poses[2].linear() * -Vec3::UnitX()).z(), -0.5, 1e-12);
}

TEST(Workspace, PositionsRunTiltByTiltThenStepByStep) {
  const Workspace w = turntableWithTilt(4, {0.0, radians(30.0)}, Vec3(0, 0, 100));
  ASSERT_EQ(w.size(), 8U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(w.poses[i].isApprox(turntable(4).poses[i]));
    // Turning comes after tilting: the raised scanner goes round the table's axis.
    EXPECT_TRUE(w.poses[4 + i].isApprox(turntable(4).poses[i] * w.poses[4]));
  }
}

TEST(Workspace, TheTiltCentreStaysWhereItIs) {
  const Vec3 centre(10, 0, 120);
  const Workspace w = turntableWithTilt(1, {radians(40.0)}, centre);
  EXPECT_TRUE((w.poses[0] * centre).isApprox(centre));
}

TEST(Workspace, MotionBetweenStepsTakesTheShortWayRound) {
  const Workspace w = turntable(8);
  EXPECT_DOUBLE_EQ(motionBetween(w, 3, 3), 0.0);
  EXPECT_NEAR(motionBetween(w, 0, 1), kPi / 4, 1e-12);
  EXPECT_NEAR(motionBetween(w, 0, 7), kPi / 4, 1e-12);
  EXPECT_NEAR(motionBetween(w, 6, 1), 3 * kPi / 4, 1e-12);
  EXPECT_NEAR(motionBetween(w, 1, 5), kPi, 1e-12);
}

TEST(Workspace, MotionBetweenTiltsAddsTurnAndTilt) {
  const Workspace w = turntableWithTilt(8, {0.0, radians(30.0)}, Vec3(0, 0, 100));
  EXPECT_NEAR(motionBetween(w, 0, 8), radians(30.0), 1e-9);
  EXPECT_NEAR(motionBetween(w, 1, 8), kPi / 4 + radians(30.0), 1e-9);
  EXPECT_NEAR(motionBetween(w, 8, 1), motionBetween(w, 1, 8), 1e-9);
}

TEST(Workspace, MotionBetweenFreePosesCountsRotationAndTranslation) {
  Workspace w;
  w.poses = {Pose::Identity(), Pose(Eigen::Translation3d(0, 50, 0)),
             Pose(Eigen::AngleAxisd(radians(20.0), Vec3::UnitX()))};
  EXPECT_NEAR(motionBetween(w, 0, 1), 0.5, 1e-12);
  EXPECT_NEAR(motionBetween(w, 0, 2), radians(20.0), 1e-9);
}

}  // namespace
}  // namespace vantage
