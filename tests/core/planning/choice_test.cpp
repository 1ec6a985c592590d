#include "planning/choice.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

PositionScore score(int position, double voidArea, double overlapArea) {
  PositionScore s;
  s.position = position;
  s.voidArea = voidArea;
  s.overlapArea = overlapArea;
  return s;
}

const ChoiceOptions kOptions{
    .leastOverlap = 100.0, .terminationThreshold = 10.0, .maxPoseSigma = 1.0, .maxRelaxations = 3};

TEST(Choice, TakesTheMostVoidAmongThoseWithEnoughOverlap) {
  std::vector<PositionScore> scores{score(0, 50, 500), score(1, 90, 99), score(2, 70, 101), score(3, 5, 500)};
  const Choice choice = choose(scores, turntable(4), 0, kOptions);
  EXPECT_EQ(choice.outcome, PlanOutcome::Found);
  EXPECT_EQ(choice.position, 2);
  EXPECT_EQ(scores[0].constraint, Constraint::Outscored);
  EXPECT_EQ(scores[1].constraint, Constraint::OverlapShort);
  EXPECT_DOUBLE_EQ(scores[1].shortBy, 1.0);
  EXPECT_EQ(scores[2].constraint, Constraint::Chosen);
  EXPECT_EQ(scores[3].constraint, Constraint::BelowThreshold);
  EXPECT_DOUBLE_EQ(scores[3].shortBy, 5.0);
}

TEST(Choice, PrefersTheTracedAreaOverThatOfPositionalSpace) {
  std::vector<PositionScore> scores{score(0, 50, 500), score(1, 90, 500)};
  scores[1].tracedVoidArea = 40.0;
  EXPECT_EQ(choose(scores, turntable(2), 0, kOptions).position, 0);
}

TEST(Choice, BreaksTiesByLeastMotionThenByLowerIndex) {
  std::vector<PositionScore> scores;
  scores.reserve(8);
  for (int i = 0; i < 8; ++i) scores.push_back(score(i, i == 1 || i == 4 || i == 6 ? 50 : 20, 500));
  EXPECT_EQ(choose(scores, turntable(8), 7, kOptions).position, 6);
  EXPECT_EQ(choose(scores, turntable(8), 0, kOptions).position, 1);
  scores[1].voidArea = 20;
  scores[2].voidArea = 50;  // as far from 4 as 6 is
  scores[4].voidArea = 20;
  EXPECT_EQ(choose(scores, turntable(8), 4, kOptions).position, 2);
}

TEST(Choice, GivesATieToTheLowerIndexWhereTheScannerIsNowhereYet) {
  std::vector<PositionScore> scores{score(0, 20, 500), score(1, 50, 500), score(2, 50, 500)};
  EXPECT_EQ(choose(scores, turntable(3), std::nullopt, kOptions).position, 1);
}

TEST(Choice, IsFinishedWhenNothingExceedsTheThreshold) {
  std::vector<PositionScore> scores{score(0, 10, 500), score(1, 9, 500)};
  const Choice choice = choose(scores, turntable(2), 0, kOptions);
  EXPECT_EQ(choice.outcome, PlanOutcome::Finished);
  EXPECT_EQ(choice.position, std::nullopt);
  EXPECT_EQ(choice.relaxations, 0);
}

TEST(Choice, HalvesTheLeastOverlapUntilAPositionReachesIt) {
  std::vector<PositionScore> scores{score(0, 50, 30), score(1, 60, 20)};
  const Choice choice = choose(scores, turntable(2), 0, kOptions);
  EXPECT_EQ(choice.outcome, PlanOutcome::Found);
  EXPECT_EQ(choice.position, 0);
  EXPECT_EQ(choice.relaxations, 2);
  EXPECT_DOUBLE_EQ(choice.leastOverlap, 25.0);
}

TEST(Choice, SaysNoOverlapWhenVoidIsLeftThatNothingReachesWithOverlap) {
  std::vector<PositionScore> scores{score(0, 50, 5), score(1, 5, 500)};
  const Choice choice = choose(scores, turntable(2), 0, kOptions);
  EXPECT_EQ(choice.outcome, PlanOutcome::NoOverlap);
  EXPECT_EQ(choice.position, std::nullopt);
  EXPECT_EQ(scores[0].constraint, Constraint::OverlapShort);
}

TEST(Choice, WhatNothingElseReachesTheTablePlaces) {
  ChoiceOptions options = kOptions;
  options.tableAloneThreshold = 30.0;
  std::vector<PositionScore> scores{score(0, 50, 0), score(1, 90, 2), score(2, 20, 4)};
  const Choice choice = choose(scores, turntable(3), 0, options);
  EXPECT_EQ(choice.outcome, PlanOutcome::Found);
  EXPECT_EQ(choice.position, 1);
  EXPECT_TRUE(choice.tableAlone);
  EXPECT_EQ(scores[0].constraint, Constraint::Outscored);
  EXPECT_EQ(scores[2].constraint, Constraint::OverlapShort);
}

TEST(Choice, TheTablePlacesNothingThatOverlapReachesOrThatIsHardlyWorthIt) {
  ChoiceOptions options = kOptions;
  options.tableAloneThreshold = 30.0;
  std::vector<PositionScore> reached{score(0, 50, 0), score(1, 20, 15)};
  const Choice overlaps = choose(reached, turntable(2), 0, options);
  EXPECT_EQ(overlaps.position, 1);
  EXPECT_FALSE(overlaps.tableAlone);
  std::vector<PositionScore> little{score(0, 29, 0), score(1, 20, 2)};
  const Choice none = choose(little, turntable(2), 0, options);
  EXPECT_EQ(none.outcome, PlanOutcome::NoOverlap);
  EXPECT_FALSE(none.tableAlone);
}

TEST(Choice, RefusesPositionsWhoseOverlapWouldNotFixThePose) {
  std::vector<PositionScore> scores{score(0, 50, 500), score(1, 90, 500)};
  scores[1].poseSigma = 1.5;
  EXPECT_EQ(choose(scores, turntable(2), 0, kOptions).position, 0);
  EXPECT_EQ(scores[1].constraint, Constraint::PoseUncertain);
  EXPECT_DOUBLE_EQ(scores[1].shortBy, 0.5);
}

TEST(Choice, AllowsTwiceThePoseErrorWithEveryRelaxation) {
  std::vector<PositionScore> scores{score(0, 50, 500)};
  scores[0].poseSigma = 3.5;
  const Choice choice = choose(scores, turntable(1), 0, kOptions);
  EXPECT_EQ(choice.outcome, PlanOutcome::Found);
  EXPECT_EQ(choice.relaxations, 2);
}

constexpr TerminationOptions kTermination{.threshold = std::nullopt, .edges = 20.0, .share = 0.001, .mostShare = 0.1};

TEST(TerminationThreshold, OfASmallModelIsWhatSoManyEdgesShow) {
  EXPECT_DOUBLE_EQ(terminationThreshold(kTermination, 2.0, 1000.0), 80.0);  // 20 edges of 2 mm, a spacing deep each
}

TEST(TerminationThreshold, OfALargeModelIsAShareOfIt) {
  EXPECT_DOUBLE_EQ(terminationThreshold(kTermination, 2.0, 1e6), 1000.0);
}

TEST(TerminationThreshold, IsNeverMoreThanAShareOfWhatWasSeen) {
  EXPECT_DOUBLE_EQ(terminationThreshold(kTermination, 2.0, 30.0), 3.0);
  EXPECT_DOUBLE_EQ(terminationThreshold(kTermination, 2.0, 0.0), 0.0);
}

TEST(TerminationThreshold, IsTheOneThatIsGiven) {
  TerminationOptions options = kTermination;
  options.threshold = 7.0;
  EXPECT_DOUBLE_EQ(terminationThreshold(options, 2.0, 1e6), 7.0);
}

}  // namespace
}  // namespace vantage
