#include <gtest/gtest.h>

#include "acquisition/steps.h"
#include "planning/choice.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// The plan after two views of the small object, when a view must promise that much.
Plan planWithThreshold(double threshold) {
  AcquisitionSettings settings;
  settings.maxViews = 2;
  const AcquisitionState state = testing::acquireSmallObject(settings, 2);
  StepOptions options = stepOptionsFor(state);
  options.planner.termination.threshold = threshold;
  return planAfter(state, computeScannerImages(*state.profile), options, {});
}

TEST(Termination, TakesViewsThatPromiseMoreThanTheThreshold) {
  const Plan plan = planWithThreshold(1.0);
  ASSERT_EQ(plan.outcome, PlanOutcome::Found);
  EXPECT_GT(promise(plan.scores[static_cast<std::size_t>(plan.position.value())]), 1.0);
}

TEST(Termination, IsFinishedWhenNoViewPromisesThatMuchAndSaysWhatIsLeft) {
  const Plan plan = planWithThreshold(1e6);
  EXPECT_EQ(plan.outcome, PlanOutcome::Finished);
  EXPECT_GT(plan.voidLeft, 0.0);
  for (const PositionScore& score : plan.scores) EXPECT_EQ(score.constraint, Constraint::BelowThreshold);
}

}  // namespace
}  // namespace vantage
