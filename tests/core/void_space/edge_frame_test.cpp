#include "void_space/edge_frame.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace vantage {
namespace {

// The edge from (0,0,0) to (2,0,0) of a triangle on its left, y > 0, that faces up.
EdgeFrame levelEdge() {
  return makeEdgeFrame({0, 0, 0}, {2, 0, 0}, {0, 0, 3});
}

TEST(EdgeFrame, AxesAreThoseOfThePaper) {
  const EdgeFrame e = levelEdge();
  EXPECT_TRUE(e.n.isApprox(Vec3(0, 0, 1)));
  EXPECT_TRUE(e.z.isApprox(Vec3(0, 1, 0))) << "z points from the edge into its triangle";
  EXPECT_TRUE(e.x.isApprox(Vec3(-1, 0, 0)));
  EXPECT_TRUE(e.x.cross(e.n).isApprox(e.z));
  EXPECT_DOUBLE_EQ(e.length, 2.0);
  EXPECT_TRUE(e.middle.isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(e.from().isZero());
  EXPECT_TRUE(e.to().isApprox(Vec3(2, 0, 0)));
}

TEST(EdgeFrame, AnglesRunFromTheTriangleOverItsNormalToItsBack) {
  const EdgeFrame e = levelEdge();
  EXPECT_DOUBLE_EQ(e.angleOf({0, 1, 0}), 0.0);
  EXPECT_DOUBLE_EQ(e.angleOf({0, 0, 1}), 0.5 * kPi);
  EXPECT_DOUBLE_EQ(e.angleOf({0, -1, 0}), kPi);
  EXPECT_DOUBLE_EQ(e.angleOf({0, 0, -1}), 1.5 * kPi);
  EXPECT_DOUBLE_EQ(e.angleOf({0, 1, -1}), 1.75 * kPi);
}

TEST(EdgeFrame, PartAlongTheEdgeDoesNotCount) {
  const EdgeFrame e = levelEdge();
  EXPECT_DOUBLE_EQ(e.angleOf({7, -1, 1}), 0.75 * kPi);
  EXPECT_DOUBLE_EQ(e.across(Vec3(3, 0, 4).normalized()), 0.8);
  EXPECT_DOUBLE_EQ(e.across(Vec3(1, 0, 0)), 0.0);
}

TEST(EdgeFrame, AngleJustBelowZeroStaysBelowAFullTurn) {
  const double angle = levelEdge().angleOf({0, 1, -1e-300});
  EXPECT_GE(angle, 0.0);
  EXPECT_LT(angle, 2.0 * kPi);
}

TEST(EdgeFrame, DirectionIsTheInverseOfAngle) {
  const EdgeFrame e = makeEdgeFrame({1, 2, 3}, {2, -1, 5}, {0.3, 0.9, -0.2});
  for (int i = 0; i < 63; ++i) {
    const double angle = 0.05 + 0.1 * i;
    EXPECT_NEAR(e.angleOf(e.direction(angle)), angle, 1e-12);
    EXPECT_NEAR(e.direction(angle).norm(), 1.0, 1e-12);
    EXPECT_NEAR(e.direction(angle).dot(e.x), 0.0, 1e-12);
  }
}

TEST(EdgeFrame, NormalLosesItsPartAlongTheEdge) {
  const EdgeFrame e = makeEdgeFrame({0, 0, 0}, {1, 0, 0}, {5, 0, 1});
  EXPECT_TRUE(e.n.isApprox(Vec3(0, 0, 1)));
}

TEST(EdgeFrame, RefusesAnEdgeWithoutLengthOrNormal) {
  EXPECT_THROW(makeEdgeFrame({1, 1, 1}, {1, 1, 1}, {0, 0, 1}), InvalidInput);
  EXPECT_THROW(makeEdgeFrame({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), InvalidInput);
  EXPECT_THROW(makeEdgeFrame({0, 0, 0}, {1, 0, 0}, Vec3::Zero()), InvalidInput);
}

}  // namespace
}  // namespace vantage
