#pragma once

#include <optional>
#include <vector>

#include "calibration/plane_fit.h"
#include "scanner/ray_grid.h"

namespace vantage {

/// How far the axis may lean from a rough one [rad].
inline constexpr double kRoughAxisLean = radians(30.0);

/// Where the axis of a table may be, scanner coordinates.
struct RoughAxis {
  Vec3 point = Vec3::Zero();       ///< [mm]
  Vec3 direction = Vec3::UnitZ();  ///< unit
};

/// The likeliest first: where the profile has it, upright on the table top; through the middle of what turns, and
/// behind that, as a scanner sees but its front. Where no table top is known, upright may also be along the columns of
/// the grid.
/// @param centre of what turns [mm]
/// @param extent of what turns [mm]
[[nodiscard]] std::vector<RoughAxis> roughAxes(const std::optional<PlaneFit>& table, const Vec3& centre,
                                               const RayGrid& rays, double extent);

/// From the last row of a grid to the first, at the depth of a point: up where the first row is on top. Unit.
[[nodiscard]] Vec3 upAlongColumns(const RayGrid& rays, const Vec3& point);

}  // namespace vantage
