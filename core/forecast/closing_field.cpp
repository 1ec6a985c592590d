#include "forecast/closing_field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vantage {
namespace {

constexpr float kOverRelaxation = 1.7F;
constexpr float kNeighbours = 6.0F;

struct UnseenVoxel {
  std::uint32_t index;
  std::uint32_t below;  // itself on the table, where the field is mirrored
};

// The unseen voxels of even and of odd steps from the corner.
std::array<std::vector<UnseenVoxel>, 2> unseenOf(const FreeSpace& space) {
  const VoxelGrid& grid = space.grid;
  std::array<std::vector<UnseenVoxel>, 2> unseen;
  for (int z = 0; z < grid.counts[2]; ++z)
    for (int y = 0; y < grid.counts[1]; ++y)
      for (int x = 0; x < grid.counts[0]; ++x) {
        const std::size_t i = grid.index(x, y, z);
        if (space.state[i] != VoxelState::Unseen) continue;
        const std::size_t below = z > 0 ? i - grid.strideZ() : i;
        unseen[static_cast<std::size_t>(x + y + z) % 2].push_back(
            {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(below)});
      }
  return unseen;
}

}  // namespace

void relaxLevels(FreeSpace& space, int sweeps) {
  const std::size_t strideY = space.grid.strideY();
  const std::size_t strideZ = space.grid.strideZ();
  std::vector<float>& level = space.level;
  const auto unseen = unseenOf(space);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& half : unseen)
      for (const UnseenVoxel& voxel : half) {
        const std::size_t i = voxel.index;
        const float pull = space.pull[i];
        const float sum = level[i - 1] + level[i + 1] + level[i - strideY] + level[i + strideY] + level[voxel.below] +
                          level[i + strideZ] + pull;
        level[i] += kOverRelaxation * (sum / (kNeighbours + pull) - level[i]);
      }
}

}  // namespace vantage
