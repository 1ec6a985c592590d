#include "forecast/closing_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vantage {
namespace {

// A box of voxels that is unseen inside; its outermost layer has the levels of a function of the place.
FreeSpace boxOf(int count, const std::function<float(int, int, int)>& level) {
  FreeSpace space;
  space.grid.counts = {count, count, count};
  space.state.assign(space.grid.size(), VoxelState::Free);
  space.level.assign(space.grid.size(), 0.0F);
  space.pull.assign(space.grid.size(), 0.0F);
  for (int z = 0; z < count; ++z)
    for (int y = 0; y < count; ++y)
      for (int x = 0; x < count; ++x) {
        const std::size_t i = space.grid.index(x, y, z);
        const bool inside = x > 0 && y > 0 && z > 0 && x < count - 1 && y < count - 1 && z < count - 1;
        if (inside)
          space.state[i] = VoxelState::Unseen;
        else
          space.level[i] = level(x, y, z);
      }
  return space;
}

// A harmonic function is found again from its values around the box.
TEST(ClosingField, IsHarmonic) {
  const auto harmonic = [](int x, int y, int z) {
    return 0.1F * static_cast<float>(x - z) + 0.02F * static_cast<float>(x * y) - 0.5F;
  };
  FreeSpace space = boxOf(13, harmonic);
  relaxLevels(space, 200);
  for (int z = 0; z < 13; ++z)
    for (int y = 0; y < 13; ++y)
      for (int x = 0; x < 13; ++x) EXPECT_NEAR(space.level[space.grid.index(x, y, z)], harmonic(x, y, z), 1e-3);
}

TEST(ClosingField, SilencePullsTowardsFree) {
  const auto inside = [](int, int, int) { return -1.0F; };
  FreeSpace still = boxOf(9, inside);
  relaxLevels(still, 100);
  FreeSpace pulled = boxOf(9, inside);
  pulled.pull.assign(pulled.grid.size(), 0.6F);
  relaxLevels(pulled, 100);
  const std::size_t middle = still.grid.index(4, 4, 4);
  EXPECT_NEAR(still.level[middle], -1.0, 1e-3);
  EXPECT_GT(pulled.level[middle], -0.8);
}

// The field is mirrored at the table: unseen voxels on it do not see what is below.
TEST(ClosingField, DoesNotFallOffTowardsTheTable) {
  FreeSpace space = boxOf(9, [](int x, int, int) { return x < 4 ? -1.0F : 1.0F; });
  for (int y = 1; y < 8; ++y)
    for (int x = 1; x < 8; ++x) space.state[space.grid.index(x, y, 0)] = VoxelState::Unseen;
  relaxLevels(space, 200);
  for (int x = 1; x < 8; ++x) {
    const float low = space.level[space.grid.index(x, 4, 0)];
    EXPECT_NEAR(low, space.level[space.grid.index(x, 4, 1)], 0.05);
  }
}

}  // namespace
}  // namespace vantage
