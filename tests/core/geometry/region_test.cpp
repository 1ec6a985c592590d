#include "geometry/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/errors.h"
#include "geometry/geometry_hash.h"
#include "geometry/region_probe.h"

namespace vantage {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Pose turned() {
  Pose pose = Pose::Identity();
  pose.translate(Vec3(3.0, -1.0, 20.0));
  pose.rotate(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()));
  return pose;
}

// A square of 10 mm about the line of sight, seen from 100 mm above.
Prism squareFromAbove(bool perspective) {
  Prism prism;
  prism.T_region_eye.translation() = Vec3(0.0, 0.0, 100.0);
  prism.perspective = perspective;
  const double half = perspective ? 0.05 : 5.0;
  prism.corners = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  prism.farthest = kInfinity;
  return prism;
}

std::vector<Region> someRegions() {
  return {BelowPlane{Vec3(0, 0, 5), Vec3::UnitZ()}, OrientedBox{turned(), Vec3(10, 20, 30)}, squareFromAbove(true),
          NearPoints{{Vec3(1, 2, 3), Vec3(4, 5, 6)}, 2.0}};
}

TEST(Region, KindsHaveNames) {
  std::vector<std::string_view> kinds;
  for (const Region& region : someRegions()) kinds.push_back(kindOf(region));
  EXPECT_EQ(kinds, (std::vector<std::string_view>{"below", "box", "lasso", "near"}));
}

TEST(Region, WhatIsNoneIsRefused) {
  for (const Region& region : someRegions()) EXPECT_NO_THROW(validate(region));
  EXPECT_THROW(validate(BelowPlane{Vec3::Zero(), Vec3(0, 0, 2)}), InvalidInput);
  EXPECT_THROW(validate(BelowPlane{Vec3(kInfinity, 0, 0), Vec3::UnitZ()}), InvalidInput);
  EXPECT_THROW(validate(OrientedBox{Pose::Identity(), Vec3(1, 0, 1)}), InvalidInput);
  Pose mirrored = Pose::Identity();
  mirrored.linear()(0, 0) = -1.0;
  EXPECT_THROW(validate(OrientedBox{mirrored, Vec3::Ones()}), InvalidInput);
  Prism prism = squareFromAbove(false);
  prism.farthest = prism.nearest;
  EXPECT_THROW(validate(prism), InvalidInput);
  prism = squareFromAbove(true);
  prism.nearest = -1.0;
  EXPECT_THROW(validate(prism), InvalidInput);
  prism = squareFromAbove(true);
  prism.corners.resize(2);
  EXPECT_THROW(validate(prism), InvalidInput);
  EXPECT_THROW(validate(NearPoints{{}, 1.0}), InvalidInput);
  EXPECT_THROW(validate(NearPoints{{Vec3::Zero()}, 0.0}), InvalidInput);
}

TEST(Region, MovesAsARigidBodyDoes) {
  const Pose T = turned();
  for (const Region& region : someRegions()) {
    const RegionProbe here(region);
    const RegionProbe there(moved(region, T));
    int in = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 p(-20.0 + 40.0 * ((i * 37) % 101) / 101.0, -20.0 + 40.0 * ((i * 53) % 103) / 103.0,
                   -20.0 + 60.0 * ((i * 71) % 107) / 107.0);
      ASSERT_EQ(here.holds(p), there.holds(T * p)) << kindOf(region) << " " << p.transpose();
      in += here.holds(p) ? 1 : 0;
    }
    EXPECT_GT(in, 0) << kindOf(region);
  }
  const Region region = someRegions()[1];
  EXPECT_TRUE(moved(region, Pose::Identity()) == region);
}

TEST(Region, HashTellsAllOfThemApart) {
  std::vector<std::uint64_t> hashes;
  for (const Region& region : someRegions()) {
    ContentHash hash;
    addRegion(hash, region);
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hash.value()), 0);
    hashes.push_back(hash.value());
  }
}

}  // namespace
}  // namespace vantage
