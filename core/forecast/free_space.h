#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "forecast/voxel_grid.h"
#include "geometry/mesh.h"
#include "geometry/ray_caster.h"
#include "scanner/view.h"

namespace vantage {

/// What is known of a cube of space.
enum class VoxelState : std::uint8_t {
  Unseen,   ///< nobody knows what is there
  Free,     ///< rays passed through it, or should have measured what is there and did not
  Surface,  ///< it lies on the model's surface
};

struct FreeSpaceOptions {
  double side = 2.0;  ///< of a voxel; larger where there would be more than `mostVoxels` of them [mm]
  /// Rays that measured nothing, though nothing known kept them from it, free a place where two of them cross at no
  /// less than this angle: one may have met surface too steeply, or none that throws light back [rad] ...
  double crossingAngle = radians(40.0);
  double silence = 0.3;  ///< ... and where they do not cross each pulls towards free so much, as 1 neighbour pulls
  std::size_t mostVoxels = 1'000'000;
};

/// The space about a partial model, as far as its views know it: where the object may still be.
struct FreeSpace {
  VoxelGrid grid;
  std::vector<VoxelState> state;  ///< per voxel
  /// Per voxel how far it lies outside: 1 where it is free, on the model's surface the distance to it in sides,
  /// positive outside of the object, from -1 to 1; 0 where it is unseen.
  std::vector<float> level;
  std::vector<float> pull;  ///< per voxel that is unseen: towards free, see FreeSpaceOptions::silence
  bool onTable = false;     ///< the grid ends at the table, which no surface passes through
};

/// Carves the space about a model with every ranging ray of its views: what lies before a sample is free, and so is
/// what rays should have measured that measured nothing.
///
/// The box is the model's, and four voxels more. Where few views were taken it is as deep as it is wide, away from
/// them: the object goes on unseen. It ends at the table, z = 0. Its outermost voxels are free.
/// @param model its triangles face the side that was seen
/// @param obstacles the same surface
/// @param views in the frame of the model, which is the table's
/// @throws InvalidInput for a model without triangles or a side that is not positive; Cancelled
[[nodiscard]] FreeSpace carveFreeSpace(const Mesh& model, const RayCaster& obstacles, std::span<const View> views,
                                       const FreeSpaceOptions& options, const Progress& progress);

}  // namespace vantage
