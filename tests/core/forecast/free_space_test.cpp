#include "forecast/free_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "core/forecast/scanned_sphere.h"

namespace vantage {
namespace {

FreeSpace carved(const testing::ScannedSphere& sphere, const FreeSpaceOptions& options, int threads = 1) {
  const RayCaster obstacles(sphere.model);
  return carveFreeSpace(sphere.model, obstacles, sphere.views, options, Progress().withThreads(threads));
}

std::size_t voxelAt(const VoxelGrid& grid, const Vec3& p) {
  const Vec3 place = (p - grid.low) / grid.side;
  return grid.index(static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z()));
}

TEST(FreeSpace, IsFreeBeforeASampleAndUnseenBehindIt) {
  const testing::ScannedSphere sphere({0});  // from +x
  const FreeSpace space = carved(sphere, {.side = 4.0});
  const Vec3 towards(testing::kSphereRadius + 8.0, 0, 0);
  EXPECT_EQ(space.state[voxelAt(space.grid, testing::sphereCentre() + towards)], VoxelState::Free);
  EXPECT_EQ(space.state[voxelAt(space.grid, testing::sphereCentre())], VoxelState::Unseen);
  EXPECT_EQ(space.state[voxelAt(space.grid, testing::sphereCentre() - 0.5 * towards)], VoxelState::Unseen);
  EXPECT_EQ(space.state[voxelAt(space.grid, testing::sphereCentre() + Vec3(testing::kSphereRadius, 0, 0))],
            VoxelState::Surface);
}

// What lies on the surface knows how far: the levels of a sphere grow with the distance from its centre.
TEST(FreeSpace, LevelsOnTheSurfaceAreItsDistance) {
  const FreeSpace space = carved(testing::ScannedSphere({0, 8, 16}), {.side = 3.0});
  std::size_t checked = 0;
  for (int z = 0; z < space.grid.counts[2]; ++z)
    for (int y = 0; y < space.grid.counts[1]; ++y)
      for (int x = 0; x < space.grid.counts[0]; ++x) {
        const std::size_t i = space.grid.index(x, y, z);
        if (space.state[i] != VoxelState::Surface) continue;
        const double height = (space.grid.centre(x, y, z) - testing::sphereCentre()).norm() - testing::kSphereRadius;
        EXPECT_NEAR(space.level[i], std::clamp(height / 3.0, -1.0, 1.0), 0.15);
        ++checked;
      }
  EXPECT_GT(checked, 300U);
}

// Beside the sphere rays of one view met nothing, which may also be surface too steep for it; two views agree.
TEST(FreeSpace, RaysThatMeasuredNothingFreeWhereTheyCross) {
  const Vec3 beside = testing::sphereCentre() + Vec3(0, testing::kSphereRadius + 6.0, 0);
  const FreeSpace one = carved(testing::ScannedSphere({0}), {.side = 4.0});
  const std::size_t inOne = voxelAt(one.grid, beside);
  EXPECT_EQ(one.state[inOne], VoxelState::Unseen);
  EXPECT_NEAR(one.pull[inOne], 0.3, 1e-6);
  const FreeSpace two = carved(testing::ScannedSphere({0, 4}), {.side = 4.0});
  EXPECT_EQ(two.state[voxelAt(two.grid, beside)], VoxelState::Free);
}

TEST(FreeSpace, IsAsDeepAsItIsWideAndEndsAtTheTable) {
  const FreeSpace space = carved(testing::ScannedSphere({0}), {.side = 4.0, .crossingAngle = radians(40.0)});
  const Vec3 high = space.grid.centre(space.grid.counts[0] - 1, space.grid.counts[1] - 1, space.grid.counts[2] - 1);
  EXPECT_GT(high.x() - space.grid.low.x(), 1.5 * testing::kSphereRadius);
  EXPECT_LT(space.grid.low.x(), -testing::kSphereRadius);
  EXPECT_GE(space.grid.low.z(), 0.0);
}

TEST(FreeSpace, NeverHasMoreVoxelsThanAllowed) {
  const FreeSpace space = carved(testing::ScannedSphere({0}), {.side = 0.01, .mostVoxels = 20000});
  EXPECT_LE(space.grid.size(), 20000U);
  EXPECT_GT(space.grid.side, 1.0);
}

TEST(FreeSpace, IsTheSameForAnyNumberOfThreads) {
  const testing::ScannedSphere sphere({0, 3, 7});
  const FreeSpace one = carved(sphere, {.side = 4.0});
  const FreeSpace four = carved(sphere, {.side = 4.0}, 4);
  EXPECT_EQ(one.state, four.state);
  EXPECT_EQ(one.level, four.level);
  EXPECT_EQ(one.pull, four.pull);
}

TEST(FreeSpace, RefusesNothingAndVoxelsWithoutASide) {
  const RayCaster nothing{Mesh{}};
  EXPECT_THROW(static_cast<void>(carveFreeSpace({}, nothing, {}, {}, {})), InvalidInput);
  const testing::ScannedSphere sphere({0});
  EXPECT_THROW(static_cast<void>(carved(sphere, {.side = 0.0})), InvalidInput);
}

}  // namespace
}  // namespace vantage
