#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "forecast/free_space.h"
#include "forecast/level_surface.h"
#include "geometry/mesh.h"
#include "geometry/ray_caster.h"
#include "scanner/profile.h"
#include "scanner/view.h"

namespace vantage {

struct ClosingOptions {
  double side = 2.5;                       ///< of a voxel [sample spacings]
  double crossingAngle = radians(40.0);    ///< see FreeSpaceOptions
  double silence = 0.3;                    ///< see FreeSpaceOptions
  std::size_t mostVoxels = 1'000'000;      ///< see FreeSpaceOptions
  double clearOfBreakdown = radians(6.0);  ///< a view looked at surface this much inside the breakdown angle [rad]
  int sweeps = 80;                         ///< of relaxation before the first look, a quarter of them after each
  int mostLooks = 6;                       ///< how often what views should have sampled is carved away
};

/// The surface that most likely closes a partial model where nobody has looked, a forecast and never part of a model.
/// Frame of the model that it closes.
struct ClosingSurface {
  std::vector<LevelFace> faces;  ///< what no view taken so far should have sampled
  Mesh mesh;                     ///< all of it: what blocks the sight
  double side = 0.0;             ///< of the voxels that it was found in: how exact it is [mm]
};

/// Predicts it: the zero level of a field that is harmonic in the unseen (relaxLevels) about the space that views
/// carved (carveFreeSpace). What a view would have sampled, had it been there, is not there: it is carved away, and the
/// field relaxed anew, until the surface is one that no view contradicts.
/// @param spacing of the samples [mm]
/// @throws as carveFreeSpace
[[nodiscard]] ClosingSurface predictClosingSurface(const Mesh& model, const RayCaster& obstacles,
                                                   std::span<const View> views, const ScannerProfile& profile,
                                                   double spacing, const ClosingOptions& options,
                                                   const Progress& progress);

}  // namespace vantage
