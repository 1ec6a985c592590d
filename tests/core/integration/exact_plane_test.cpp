#include "integration/exact_plane.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(ExactPlane, OrientationTellsTheFinestTurnAtTheLimit) {
  const PlanePoint a{-kPlaneLimit, -kPlaneLimit};
  const PlanePoint b{kPlaneLimit, kPlaneLimit};
  EXPECT_EQ(orientation(a, b, {0, 0}), 0);
  EXPECT_GT(orientation(a, b, {0, 1}), 0);
  EXPECT_LT(orientation(a, b, {1, 0}), 0);
}

TEST(ExactPlane, PointOnTheCircleIsNotInside) {
  const PlanePoint a{5, 0};
  const PlanePoint b{0, 5};
  const PlanePoint c{-5, 0};
  EXPECT_FALSE(insideCircle(a, b, c, {3, -4}));
  EXPECT_TRUE(insideCircle(a, b, c, {3, -3}));
  EXPECT_FALSE(insideCircle(a, b, c, {4, -4}));
}

TEST(ExactPlane, CircleIsExactAtTheLimit) {
  constexpr std::int32_t kFar = kPlaneLimit;
  EXPECT_FALSE(insideCircle({kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}, {-kFar, -kFar}));
  EXPECT_TRUE(insideCircle({kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}, {-kFar + 1, -kFar}));
}

TEST(ExactPlane, BetweenLeavesOutTheEnds) {
  EXPECT_TRUE(strictlyBetween({0, 0}, {4, 8}, {1, 2}));
  EXPECT_TRUE(strictlyBetween({0, 3}, {0, -3}, {0, 0}));
  EXPECT_FALSE(strictlyBetween({0, 0}, {4, 8}, {4, 8}));
  EXPECT_FALSE(strictlyBetween({0, 0}, {4, 8}, {5, 10}));
}

TEST(ExactPlane, TrianglesThatShareOnlyAnEdgeOrCornerDoNotOverlap) {
  const PlanePoint t[3] = {{0, 0}, {4, 0}, {0, 4}};
  EXPECT_FALSE(trianglesOverlap(t, {{4, 0}, {4, 4}, {0, 4}}));
  EXPECT_FALSE(trianglesOverlap(t, {{0, 0}, {-1, 0}, {0, -1}}));
  EXPECT_TRUE(trianglesOverlap(t, {{1, 1}, {2, 1}, {1, 2}}));
  // They cross like the two of a star, no corner inside the other.
  EXPECT_TRUE(trianglesOverlap({{0, 0}, {6, 0}, {3, 6}}, {{0, 4}, {3, -2}, {6, 4}}));
}

}  // namespace
}  // namespace vantage
