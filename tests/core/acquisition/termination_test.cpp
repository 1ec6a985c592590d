#include <gtest/gtest.h>

#include "acquisition/steps.h"
#include "core/acquisition/small_scene.h"

namespace vantage {
namespace {

// The plan after two views of the small object, when every view counts as one that shows little.
Plan planWithLittleToSee(double leftShare) {
  AcquisitionSettings settings;
  settings.maxViews = 2;
  const AcquisitionState state = testing::acquireSmallObject(settings, 2);
  StepOptions options = stepOptionsFor(state);
  options.planner.termination.edges = 1e6;
  options.planner.termination.leastEdges = 1.0;
  options.planner.termination.share = 0.0;
  options.planner.termination.leftShare = leftShare;
  return planAfter(state, computeScannerImages(*state.profile), options, {});
}

TEST(Termination, TakesViewsThatShowLittleWhileMuchIsLeft) {
  const Plan plan = planWithLittleToSee(1e-6);
  EXPECT_EQ(plan.outcome, PlanOutcome::Found);
  EXPECT_GT(plan.voidLeft, 0.0);
}

TEST(Termination, IsFinishedWhenLittleIsLeftAltogether) {
  const Plan plan = planWithLittleToSee(1e6);
  EXPECT_EQ(plan.outcome, PlanOutcome::Finished);
  EXPECT_GT(plan.voidLeft, 0.0);
  for (const PositionScore& score : plan.scores) EXPECT_EQ(score.constraint, Constraint::BelowThreshold);
}

}  // namespace
}  // namespace vantage
