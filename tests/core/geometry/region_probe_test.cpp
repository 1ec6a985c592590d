#include "geometry/region_probe.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

TEST(RegionProbe, BelowAPlaneIsWhereItsNormalPointsAwayFrom) {
  const RegionProbe below(BelowPlane{Vec3(0, 0, 5), Vec3::UnitZ()});
  EXPECT_TRUE(below.holds({100, -3, 4.9}));
  EXPECT_TRUE(below.holds({0, 0, 5}));
  EXPECT_FALSE(below.holds({0, 0, 5.1}));
  EXPECT_TRUE(below.holds({0, 0, 5.1}, 0.2));
}

TEST(RegionProbe, ABoxMayBeTurned) {
  Pose pose = Pose::Identity();
  pose.translate(Vec3(10, 0, 0));
  pose.rotate(Eigen::AngleAxisd(radians(45.0), Vec3::UnitZ()));
  const RegionProbe box(OrientedBox{pose, Vec3(2, 2, 2)});
  EXPECT_TRUE(box.holds({11.4, 0, 0})) << "a corner of the turned box";
  EXPECT_FALSE(box.holds({10.9, 0.9, 0})) << "a corner of the box that is not turned";
  EXPECT_FALSE(box.holds({10, 0, 1.1}));
  EXPECT_TRUE(box.holds({10, 0, 1.1}, 0.11));
}

TEST(RegionProbe, ALassoGoesThroughAsFarAsItIsDeep) {
  Prism prism;
  prism.T_region_eye.translation() = Vec3(0, 0, 100);
  prism.corners = {{0, 0}, {10, 0}, {10, 10}, {5, 2}, {0, 10}};  // a notch from above
  prism.farthest = kForEver;
  EXPECT_TRUE(RegionProbe(prism).holds({1, 1, 50}));
  EXPECT_TRUE(RegionProbe(prism).holds({1, 1, -5000}));
  EXPECT_FALSE(RegionProbe(prism).holds({1, 1, 101})) << "behind the eye";
  EXPECT_FALSE(RegionProbe(prism).holds({5, 6, 50})) << "in the notch";
  EXPECT_TRUE(RegionProbe(prism).holds({5, 2.5, 50}, 0.6)) << "but near its border";
  prism.farthest = 60;
  EXPECT_TRUE(RegionProbe(prism).holds({1, 1, 41}));
  EXPECT_FALSE(RegionProbe(prism).holds({1, 1, 39}));
  EXPECT_TRUE(RegionProbe(prism).holds({1, 1, 39}, 1.5));
}

TEST(RegionProbe, LinesOfSightThatMeetMakeAPyramid) {
  Prism prism;
  prism.T_region_eye.translation() = Vec3(0, 0, 100);
  prism.perspective = true;
  prism.corners = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  prism.farthest = kForEver;
  const RegionProbe lasso(prism);
  EXPECT_TRUE(lasso.holds({0.9, 0, 90}));
  EXPECT_FALSE(lasso.holds({1.1, 0, 90}));
  EXPECT_TRUE(lasso.holds({9.9, 0, 0}));
  EXPECT_FALSE(lasso.holds({10.1, 0, 0}));
  EXPECT_TRUE(lasso.holds({10.1, 0, 0}, 0.2));
  EXPECT_FALSE(lasso.holds({0, 0, 101}));
}

TEST(RegionProbe, NearPointsAreFoundInAnyCell) {
  const RegionProbe near(NearPoints{{Vec3(-0.01, 0, 0), Vec3(50, 50, 50)}, 2.0});
  EXPECT_TRUE(near.holds({1.9, 0, 0}));
  EXPECT_FALSE(near.holds({2.1, 0, 0}));
  EXPECT_TRUE(near.holds({2.1, 0, 0}, 0.5));
  EXPECT_TRUE(near.holds({54, 50, 50}, 2.0));
  EXPECT_FALSE(near.holds({54.1, 50, 50}, 2.0));
}

TEST(RegionProbe, WhatIsNowhereIsNotIn) {
  EXPECT_FALSE(RegionProbe(BelowPlane{}).holds(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
}

TEST(RegionProbe, ARegionThatIsNoneIsRefused) {
  EXPECT_THROW(RegionProbe(NearPoints{{}, 1.0}), InvalidInput);
}

}  // namespace
}  // namespace vantage
