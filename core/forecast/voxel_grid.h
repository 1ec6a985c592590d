#pragma once

#include <array>
#include <cstddef>

#include "geometry/vectors.h"

namespace vantage {

/// A box of space in cubes, numbered along x, then y, then z.
struct VoxelGrid {
  Vec3 low = Vec3::Zero();      ///< lowest corner [mm]
  double side = 1.0;            ///< of a cube [mm]
  std::array<int, 3> counts{};  ///< cubes along x, y and z

  [[nodiscard]] std::size_t size() const { return strideZ() * static_cast<std::size_t>(counts[2]); }
  [[nodiscard]] std::size_t strideY() const { return static_cast<std::size_t>(counts[0]); }
  [[nodiscard]] std::size_t strideZ() const { return strideY() * static_cast<std::size_t>(counts[1]); }
  [[nodiscard]] std::size_t stride(std::size_t axis) const { return axis == 0 ? 1 : axis == 1 ? strideY() : strideZ(); }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(z) * strideZ() + static_cast<std::size_t>(y) * strideY() +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] Vec3 centre(int x, int y, int z) const { return low + side * Vec3(x + 0.5, y + 0.5, z + 0.5); }
};

}  // namespace vantage
