#include "acquisition/steps.h"

#include <gtest/gtest.h>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// A scan of position 2, taken where the table believed to be when it was 1.8 mm, nine sigmas of one move, beside it.
AcquisitionState addMisplaced(std::int64_t number) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  SimulatedScanner scanner(testing::smallObject(), state.profile, {1, true});
  const auto scanOf = [&](int position) { return std::make_shared<RangeImage>(scanner.scan(position, Progress())); };
  state = addScan(state, {0, scanOf(0)}, std::nullopt, stepOptionsFor(state), {});
  const auto misplaced = scanOf(2);
  misplaced->T_object_scanner = Eigen::Translation3d(1.8, 0.0, 0.0) * misplaced->T_object_scanner;
  return addScan(state, {number, misplaced}, std::nullopt, stepOptionsFor(state), {});
}

TEST(AddScan, RejectsAScanThatTheMechanicsCannotHaveBroughtThere) {
  const AcquisitionState state = addMisplaced(1);
  ASSERT_EQ(state.rejected.size(), 1U);
  EXPECT_EQ(state.rejected[0].registration.finding.reason, VerdictReason::Motion);
  EXPECT_EQ(state.views.size(), 1U);
}

TEST(AddScan, KnowsThatTheTableMovedForEveryScanInBetween) {
  const AcquisitionState state = addMisplaced(36);
  EXPECT_TRUE(state.rejected.empty());
  ASSERT_EQ(state.views.size(), 2U);
  const Pose truth = state.profile->workspace.poses[2];
  EXPECT_LT((state.views[1].T_object_scanner.translation() - truth.translation()).norm(), 0.3);
}

}  // namespace
}  // namespace vantage
