#pragma once

#include <array>
#include <span>

#include "geometry/mesh.h"

namespace vantage {

/// The points p with normal . p = offset; its front is where the normal points.
struct SurfacePlane {
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double offset = 0.0;          ///< [mm]

  /// [mm], positive in front of it.
  [[nodiscard]] double distance(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// The plane through three points, its front where they are counter-clockwise.
/// @throws InvalidInput when they are on a line or not finite
[[nodiscard]] SurfacePlane planeThrough(const std::array<Vec3, 3>& points);

/// The plane to which points are nearest in the sense of least squares; its front is the side of `front`.
/// @throws InvalidInput for fewer than three points, points on a line, or ones that are not finite
[[nodiscard]] SurfacePlane planeFit(std::span<const Vec3> points, const Vec3& front);

}  // namespace vantage
