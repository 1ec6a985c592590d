#include "acquisition/views_to_come.h"

#include <gtest/gtest.h>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

PositionScore promising(double area) {
  PositionScore score;
  score.voidArea = area;
  return score;
}

// Views that promised so much, each taken in 2 s, and a next one.
AcquisitionState afterViews(const std::vector<double>& promises, double next, double threshold) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  state.settings.maxViews = 40;
  for (std::size_t i = 0; i <= promises.size(); ++i) {
    auto image = std::make_shared<RangeImage>();
    image->station.position = static_cast<int>(i);
    KeptScan scan;
    scan.number = static_cast<std::int64_t>(i);
    scan.view.image = image;
    if (i > 0) scan.record.predicted = promising(promises[i - 1]);
    scan.record.seconds = {{Phase::Scan, 0.5}, {Phase::Register, 1.5}};
    state.scans.push_back(scan);
  }
  auto plan = std::make_shared<Plan>();
  plan->outcome = PlanOutcome::Found;
  plan->position = 1;
  plan->terminationThreshold = threshold;
  plan->scores.assign(3, promising(0.0));
  plan->scores[1] = promising(next);
  state.plan = plan;
  return state;
}

TEST(ViewsToCome, PromisesThatFallByHalfGoOnToDoSo) {
  // 800, 400, 200 were promised and 100 comes next: 100, 50 and 25 are worth more than 20.
  const auto come = viewsToCome(afterViews({800.0, 400.0, 200.0}, 100.0, 20.0));
  ASSERT_TRUE(come);
  EXPECT_EQ(come->views, 3);
  EXPECT_NEAR(come->seconds, 6.0, 1e-9);
}

TEST(ViewsToCome, WhatIsWorthLessFromTheNextOnIsTheLast) {
  const auto come = viewsToCome(afterViews({800.0, 400.0, 200.0}, 21.0, 20.0));
  ASSERT_TRUE(come);
  EXPECT_EQ(come->views, 1);
}

TEST(ViewsToCome, NeverMoreThanMayBeTaken) {
  AcquisitionState state = afterViews({800.0, 790.0, 780.0}, 770.0, 1.0);
  state.settings.maxViews = 6;
  ASSERT_TRUE(viewsToCome(state));
  EXPECT_EQ(viewsToCome(state)->views, 2);
}

TEST(ViewsToCome, NobodyKnowsBeforeSomeViewsAreTakenOrOnceNothingComesNext) {
  EXPECT_FALSE(viewsToCome(AcquisitionState{}));
  EXPECT_FALSE(viewsToCome(afterViews({800.0}, 100.0, 20.0)));
  AcquisitionState ended = afterViews({800.0, 400.0, 200.0}, 100.0, 20.0);
  ended.termination = Termination::EndedByOperator;
  EXPECT_FALSE(viewsToCome(ended));
}

}  // namespace
}  // namespace vantage
