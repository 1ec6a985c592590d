#include "acquisition/steps.h"

#include <gtest/gtest.h>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// A scan of position 2, taken where the table believed to be when it was 1.8 mm, nine sigmas of one move, beside it.
AcquisitionState addMisplaced(std::int64_t number) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), state.profile, {1, true});
  const auto scanOf = [&](int position) { return std::make_shared<RangeImage>(scanFrom(rig, position, Progress())); };
  state = addScan(state, {0, scanOf(0)}, std::nullopt, stepOptionsFor(state), {});
  const auto misplaced = scanOf(2);
  misplaced->T_table_scanner = Eigen::Translation3d(1.8, 0.0, 0.0) * misplaced->T_table_scanner;
  return addScan(state, {number, misplaced}, std::nullopt, stepOptionsFor(state), {});
}

TEST(AddScan, RejectsAScanThatTheMechanicsCannotHaveBroughtThere) {
  const AcquisitionState state = addMisplaced(1);
  ASSERT_EQ(state.scans.size(), 2U);
  EXPECT_EQ(state.scans[1].status, ScanStatus::Rejected);
  EXPECT_EQ(state.scans[1].record.registration.finding.reason, VerdictReason::Motion);
  EXPECT_EQ(countScans(state, ScanStatus::In), 1U);
}

TEST(AddScan, KnowsThatTheTableMovedForEveryScanInBetween) {
  const AcquisitionState state = addMisplaced(36);
  ASSERT_EQ(countScans(state, ScanStatus::In), 2U);
  const Pose truth = state.profile->workspace.poses[2];
  EXPECT_LT((state.scans[1].view.T_object_scanner.translation() - truth.translation()).norm(), 0.3);
}

}  // namespace
}  // namespace vantage
