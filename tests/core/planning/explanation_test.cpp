#include "planning/explanation.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "planning/choice.h"

namespace vantage {
namespace {

// Four positions: 0 overlaps too little, 1 is chosen, 2 is the runner-up, 3 shows too little.
Plan makePlan() {
  Plan plan;
  auto voids = std::make_shared<VoidSurface>();
  for (const auto edgeClass : {EdgeClass::OuterJump, EdgeClass::InnerJump, EdgeClass::OuterJump}) {
    VoidPatch patch;
    patch.edgeClass = edgeClass;
    patch.weight = 10.0 * static_cast<double>(voids->patches.size() + 1);
    voids->patches.push_back(patch);
  }
  plan.voids = voids;
  const double areas[4][2] = {{400, 20}, {300, 900}, {200, 950}, {5, 990}};
  for (int i = 0; i < 4; ++i) {
    PositionScore score;
    score.position = i;
    score.voidArea = areas[i][0];
    score.overlapArea = areas[i][1];
    plan.scores.push_back(score);
  }
  plan.scores[1].tracedVoidArea = 320.0;
  plan.scores[1].patches = {0, 2};
  plan.scores[1].poseSigma = 0.02;
  plan.scores[1].weakMotions = {{WeakMotion::Kind::Turn, Vec3::UnitZ()}};
  const Choice choice =
      choose(plan.scores, turntable(4), 0, {.leastOverlap = 100.0, .terminationThreshold = 10.0, .maxPoseSigma = 1.0});
  plan.outcome = choice.outcome;
  plan.position = choice.position;
  plan.leastOverlap = choice.leastOverlap;
  plan.terminationThreshold = 10.0;
  return plan;
}

TEST(Explanation, EveryFigureFollowsFromTheRecord) {
  const Plan plan = makePlan();
  for (const PositionScore& score : plan.scores) {
    const Explanation why = explain(plan, score.position);
    EXPECT_EQ(why.constraint, score.constraint);
    EXPECT_EQ(why.voidArea, score.voidArea);
    EXPECT_EQ(why.promise, promise(score));
    EXPECT_EQ(why.overlapArea, score.overlapArea);
    EXPECT_EQ(why.leastOverlap, plan.leastOverlap);
    EXPECT_EQ(why.terminationThreshold, plan.terminationThreshold);
    if (why.constraint == Constraint::OverlapShort) {
      EXPECT_DOUBLE_EQ(why.shortBy, plan.leastOverlap - score.overlapArea);
    }
    if (why.constraint == Constraint::BelowThreshold) {
      EXPECT_DOUBLE_EQ(why.shortBy, plan.terminationThreshold - promise(score));
    }
  }
}

TEST(Explanation, SaysWhatAForecastRestsOn) {
  Plan plan = makePlan();
  EXPECT_FALSE(explain(plan, 1).forecast.has_value());
  plan.forecast = PlanForecast{{0.8, 0.3}, {}, true};
  EXPECT_EQ(explain(plan, 1).forecast.value().trust.factor, 0.8);
  EXPECT_TRUE(explain(plan, 1).forecast.value().probing);
}

TEST(Explanation, AddsUpThePatchesThatAPositionWins) {
  const Explanation why = explain(makePlan(), 1);
  EXPECT_EQ(why.patches, 2U);
  EXPECT_DOUBLE_EQ(why.patchArea, 40.0);
  EXPECT_EQ(why.patchesByClass[static_cast<std::size_t>(EdgeClass::OuterJump)], 2U);
  EXPECT_EQ(why.patchesByClass[static_cast<std::size_t>(EdgeClass::InnerJump)], 0U);
}

TEST(Explanation, ComparesTheChoiceWithTheRunnerUpAndTheOthersWithTheChoice) {
  const Plan plan = makePlan();
  EXPECT_EQ(runnerUp(plan), 2);
  EXPECT_EQ(explain(plan, 1).rival, 2);
  EXPECT_DOUBLE_EQ(explain(plan, 1).rivalPromise, 200.0);
  for (const int other : {0, 2, 3}) {
    EXPECT_EQ(explain(plan, other).rival, 1);
    EXPECT_DOUBLE_EQ(explain(plan, other).rivalPromise, 320.0);
    EXPECT_DOUBLE_EQ(explain(plan, other).rivalOverlap, 900.0);
  }
}

TEST(Explanation, RanksByWhatPositionsPromise) {
  const Plan plan = makePlan();
  EXPECT_EQ(explain(plan, 0).rank, 1);
  EXPECT_EQ(explain(plan, 1).rank, 2);
  EXPECT_EQ(explain(plan, 3).rank, 4);
}

TEST(Explanation, HasNoRivalWhenNothingElseIsAllowed) {
  Plan plan = makePlan();
  plan.scores[2].constraint = Constraint::BelowThreshold;
  EXPECT_EQ(explain(plan, 1).rival, std::nullopt);
  plan.position.reset();
  EXPECT_EQ(explain(plan, 0).rival, std::nullopt);
}

TEST(Explanation, RefusesPositionsThatThePlanDoesNotHave) {
  EXPECT_THROW(static_cast<void>(explain(makePlan(), 4)), InvalidInput);
  EXPECT_THROW(static_cast<void>(explain(makePlan(), -1)), InvalidInput);
}

}  // namespace
}  // namespace vantage
