#pragma once

#include <cstddef>
#include <vector>

#include "forecast/free_space.h"
#include "geometry/mesh.h"

namespace vantage {

/// A piece of a level surface: the face between two neighbouring voxels of which one lies inside, moved to where the
/// levels cross 0.
struct LevelFace {
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, outward
  double area = 0.0;            ///< [mm^2]
  std::size_t inside = 0;       ///< the voxel whose level is negative
};

/// The surface at which the levels change their sign, but for where it is the model's own.
struct LevelSurface {
  std::vector<LevelFace> faces;
  Mesh mesh;  ///< triangles 2 i and 2 i + 1 are face i; they face outward
};

/// Finds the zero level by surface nets: a vertex in every cell of eight voxels that it passes through, at the mean of
/// its crossings with the cell's edges, a quad for every two neighbouring voxels of different signs.
[[nodiscard]] LevelSurface levelSurface(const FreeSpace& space);

}  // namespace vantage
