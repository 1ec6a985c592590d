#pragma once

#include <span>

#include "base/progress.h"
#include "geometry/ray_caster.h"
#include "scanner/ray_grid.h"

namespace vantage {

/// What may hide a point from a scanner: surface that is known. Immutable; queries may run on any thread.
class KnownSurface {
 public:
  /// @param meshes in one frame @param margin what lies so near to a point does not hide it [mm]
  /// @throws InvalidInput as RayCaster; Cancelled
  KnownSurface(std::span<const Mesh* const> meshes, double margin, const Progress& progress);

  /// Whether a scanner cannot have measured a point along one of its rays: the ray is blocked, or the line of sight of
  /// every receiver.
  /// @param p scanner coordinates @param T_surface_scanner where the scanner is
  [[nodiscard]] bool hides(const Vec3& p, const RayGrid& rays, std::size_t ray, const Pose& T_surface_scanner) const;

 private:
  RayCaster caster_;
  double margin_;
};

}  // namespace vantage
