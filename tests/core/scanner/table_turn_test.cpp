#include "scanner/table_turn.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

TEST(TableTurn, TurnsTheTableAgainstTheScanner) {
  const Workspace table = turntable(8);
  EXPECT_NEAR(turnBetween(table, 0, 1).angle, -radians(45.0), 1e-12);
  EXPECT_NEAR(turnBetween(table, 1, 0).angle, radians(45.0), 1e-12);
  EXPECT_NEAR(turnBetween(table, 3, 3).angle, 0.0, 1e-12);
}

TEST(TableTurn, TakesTheShorterWay) {
  const Workspace table = turntable(8);
  EXPECT_NEAR(turnBetween(table, 0, 7).angle, radians(45.0), 1e-12);
  EXPECT_NEAR(turnBetween(table, 7, 1).angle, -radians(90.0), 1e-12);
  EXPECT_NEAR(turnBetween(table, 0, 4).angle, kPi, 1e-12);
  EXPECT_NEAR(turnBetween(table, 4, 0).angle, kPi, 1e-12);
}

TEST(TableTurn, TellsTiltFromTurn) {
  const Workspace workspace = turntableWithTilt(4, {0.0, radians(30.0)}, Vec3(0, 0, 100));
  const TableTurn turn = turnBetween(workspace, 0, 5);
  EXPECT_NEAR(turn.angle, -radians(90.0), 1e-9);
  EXPECT_NEAR(turn.tilt, radians(30.0), 1e-9);
  EXPECT_NEAR(turnBetween(workspace, 6, 2).tilt, -radians(30.0), 1e-9);
}

TEST(TableTurn, RefusesPositionsThatTheWorkspaceDoesNotHave) {
  EXPECT_THROW(static_cast<void>(turnBetween(turntable(4), 0, 4)), InvalidInput);
  EXPECT_THROW(static_cast<void>(turnBetween(turntable(4), -1, 0)), InvalidInput);
}

TEST(AzimuthOf, IsWhereTheScannerStandsSeenFromTheObject) {
  ScannerProfile profile;
  profile.rays =
      std::make_shared<const RayGrid>(makeRays(LinearStripe{{200.0, 0.0, 30.0}, 40.0, 5, 9, 80.0}, ReceiverOffsets{}));
  const Workspace workspace = turntable(4);
  EXPECT_TRUE(scannerPlace(profile, workspace.poses[0]).isApprox(Vec3(200.0, 0.0, 30.0), 1e-12));
  EXPECT_NEAR(azimuthOf(profile, workspace.poses[0]), 0.0, 1e-9);
  EXPECT_NEAR(azimuthOf(profile, workspace.poses[1]), 0.5 * kPi, 1e-9);
  EXPECT_NEAR(azimuthOf(profile, workspace.poses[3]), -0.5 * kPi, 1e-9);
}

}  // namespace
}  // namespace vantage
