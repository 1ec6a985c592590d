#include "scanner/simulated_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

std::shared_ptr<const ScannerProfile> erringProfile() {
  ScannerProfile profile;
  profile.workspace = turntable(4);
  profile.mechanics = {.angleSigma = radians(0.5), .positionSigma = 0.4};
  return std::make_shared<const ScannerProfile>(profile);
}

TEST(SimulatedTable, TheFirstScanHasNoMechanicalErrorAndLaterOnesAddUp) {
  const SimulatedTable table(erringProfile(), {});
  EXPECT_TRUE(table.mechanicalError(0).isApprox(Pose::Identity()));
  double shift = 0.0;
  double turn = 0.0;
  constexpr int kMoves = 400;
  for (int move = 1; move <= kMoves; ++move) {
    const Pose step = table.mechanicalError(move - 1).inverse() * table.mechanicalError(move);
    shift += step.translation().squaredNorm() / (2.0 * kMoves);
    turn += std::pow(Eigen::AngleAxisd(step.linear()).angle(), 2) / kMoves;
    EXPECT_NEAR(step.translation().z(), 0.0, 1e-12);
    EXPECT_NEAR(step.linear()(2, 2), 1.0, 1e-12);
  }
  EXPECT_NEAR(std::sqrt(shift), 0.4, 5.0 * 0.4 / std::sqrt(4.0 * kMoves));
  EXPECT_NEAR(std::sqrt(turn), radians(0.5), 5.0 * radians(0.5) / std::sqrt(2.0 * kMoves));
}

TEST(SimulatedTable, AnIdealOneNeverErrs) {
  const SimulatedTable table(erringProfile(), {.ideal = true});
  EXPECT_TRUE(table.mechanicalError(5).isApprox(Pose::Identity()));
}

TEST(SimulatedTable, ReportsWhereItWasToldToGoAndKnowsTheTruth) {
  const auto profile = erringProfile();
  SimulatedTable table(profile, {}, 3);
  EXPECT_FALSE(table.where());
  EXPECT_FALSE(table.truth());
  const ReachedPose reached = table.moveTo(2, {});
  EXPECT_EQ(reached.position, 2);
  EXPECT_EQ(reached.knownBy, PoseSource::Commanded);
  EXPECT_EQ(reached.T_table_scanner.matrix(), profile->workspace.poses[2].matrix());
  ASSERT_TRUE(reached.uncertainty);
  EXPECT_EQ(reached.uncertainty->positionSigma, 0.4);
  ASSERT_TRUE(table.truth());
  EXPECT_EQ(table.truth()->matrix(), (table.mechanicalError(3) * profile->workspace.poses[2]).matrix());
}

TEST(SimulatedTable, AMoveWhoseScanWasNotTakenIsRepeatedToTheSamePlace) {
  SimulatedTable table(erringProfile(), {}, 3);
  static_cast<void>(table.moveTo(2, {}));
  const Pose first = *table.truth();
  static_cast<void>(table.moveTo(0, {}));
  static_cast<void>(table.moveTo(2, {}));
  EXPECT_EQ(table.truth()->matrix(), first.matrix());
  table.countScan();
  static_cast<void>(table.moveTo(2, {}));
  EXPECT_GT((table.truth()->translation() - first.translation()).norm(), 1e-3);
}

}  // namespace
}  // namespace vantage
