#pragma once

#include <memory>
#include <optional>

#include "positional_space/positional_space_grid.h"
#include "scanner/ray_grid.h"

namespace vantage {

/// A ranging ray as it leaves through the middle of a surface cell, and how its neighbours differ. Slopes are
/// (d.across, d.up) / d.normal of the outward direction d = -r.
struct FanRay {
  Vec3 direction = Vec3::UnitX();  ///< outward, unit
  Vec2 slope = Vec2::Zero();
  Eigen::Matrix2d fan = Eigen::Matrix2d::Zero();  ///< [1/mm] change of the slope per shift across the cell
  double sourceDistance = 0.0;                    ///< [mm] outward to the ray's origin
  std::size_t sample = 0;                         ///< the nearest ranging ray
};

/// The rays of a scanner, or of one with more than a million every n-th row and column, so that some 250,000 are left.
[[nodiscard]] std::shared_ptr<const RayGrid> usefulRays(const std::shared_ptr<const RayGrid>& rays);

/// Interpolates a scanner's ranging rays where they cross positional space, even behind the scanner's head. Of a
/// scanner with more than a million rays every n-th row and column is interpolated, so many that some 250,000 rays are
/// left: a cell of positional space, of which there are no more than 200,000 on its surface, is crossed by many of the
/// others.
class RayFan {
 public:
  /// @param reach [mm] rays are followed this far behind their origins.
  RayFan(const std::shared_ptr<const RayGrid>& rays, double reach);

  /// The ray through the middle of a cell; none outside of the scanner's field of view and where rays only enter the
  /// far side or graze. @param hint a place to begin at; becomes the place found.
  [[nodiscard]] std::optional<FanRay> through(const SurfaceCell& cell, const Pose& T_object_scanner,
                                              std::optional<GridPosition>& hint) const;

 private:
  std::shared_ptr<const RayGrid> whole_;
  int step_;      // of the rows and columns of `whole_` that are interpolated
  RayGrid rays_;  // origins set back by reach_
  double reach_;
};

}  // namespace vantage
