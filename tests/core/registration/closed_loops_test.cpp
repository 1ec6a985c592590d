#include "registration/closed_loops.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace vantage {
namespace {

using Flags = std::vector<bool>;
using Groups = std::vector<std::size_t>;

TEST(ClosedLoops, AChainHoldsNothing) {
  const std::vector<ViewTie> ties{{0, 1}, {1, 2}, {2, 3}};
  EXPECT_EQ(heldTogether(ties, {true, false, false, false}), (Groups{0, 1, 2, 3}));
}

TEST(ClosedLoops, ALoopThroughAKnownViewHoldsAllOfIt) {
  const std::vector<ViewTie> ties{{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  EXPECT_EQ(heldTogether(ties, {true, false, false, false}), (Groups{0, 0, 0, 0}));
}

TEST(ClosedLoops, AChainBetweenKnownViewsIsALoop) {
  const std::vector<ViewTie> ties{{0, 1}, {1, 2}, {2, 3}};
  EXPECT_EQ(heldTogether(ties, {true, false, false, true}), (Groups{0, 0, 0, 0}));
}

TEST(ClosedLoops, ALoopThatHangsOnOneTieHoldsItselfAlone) {
  // 1, 2 and 3 hold each other, but only 1 holds them to what is known.
  const std::vector<ViewTie> ties{{0, 1}, {1, 2}, {2, 3}, {1, 3}};
  EXPECT_EQ(heldTogether(ties, {true, false, false, false}), (Groups{0, 1, 1, 1}));
}

TEST(ClosedLoops, WhatHangsOnALoopIsNotHeld) {
  const std::vector<ViewTie> ties{{0, 1}, {1, 2}, {0, 2}, {2, 3}};
  EXPECT_EQ(heldTogether(ties, {true, false, false, false}), (Groups{0, 0, 0, 1}));
}

TEST(ClosedLoops, LoopsHoldWithoutAKnownView) {
  const std::vector<ViewTie> ties{{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}};
  EXPECT_EQ(heldTogether(ties, Flags(6, false)), (Groups{1, 1, 1, 2, 2, 2}));
  EXPECT_TRUE(heldTogether({}, {}).empty());
}

std::vector<ViewTie> tiesOf(const std::vector<View>& views, const std::vector<Pose>& poses) {
  return tiesAmong(prepareViews(views, {}), poses, Flags(views.size(), true), {}, {});
}

TEST(ClosedLoops, NeighboursTieEachOtherWhereTheyAre) {
  const auto profile = testing::makeProfile(0.05);
  const Mesh ball = testing::makeBall();
  const std::vector<View> views{testing::scanFrom(ball, profile, 0), testing::scanFrom(ball, profile, 9),
                                testing::scanFrom(ball, profile, 45)};
  std::vector<Pose> poses;
  for (const View& view : views) poses.push_back(view.T_object_scanner);
  EXPECT_EQ(tiesOf(views, poses), std::vector<ViewTie>({{0, 1}}));
  EXPECT_TRUE(tiesAmong(prepareViews(views, {}), poses, {true, false, true}, {}, {}).empty());
  // The two would fit, but not there.
  poses[1] = testing::randomMotion(3, radians(2.0), 1.0, testing::centroid(views[1])) * poses[1];
  EXPECT_TRUE(tiesOf(views, poses).empty());
}

TEST(ClosedLoops, WhatSlidesIsTiedAsWell) {
  const auto profile = testing::makeProfile(0.05);
  const std::vector<View> views{testing::scanVase(profile, 0), testing::scanVase(profile, 9)};
  EXPECT_EQ(tiesOf(views, {views[0].T_object_scanner, views[1].T_object_scanner}), std::vector<ViewTie>({{0, 1}}));
}

}  // namespace
}  // namespace vantage
