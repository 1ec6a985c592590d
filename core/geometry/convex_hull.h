#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {

/// The convex hull of points as a closed mesh, outward oriented.
struct ConvexHull {
  Mesh mesh;                         ///< corners only; facets with more corners are cut into triangles
  std::vector<Vec3> normals;         ///< per triangle: unit, outward; that of the facet, also where a triangle is flat
  std::vector<std::uint32_t> point;  ///< per vertex: index among the points
  double volume = 0.0;               ///< [mm^3]
  Vec3 centroid = Vec3::Zero();      ///< of the solid [mm]
};

/// Deterministic.
/// @param points [mm], finite
/// @throws InvalidInput for fewer than four points and for points that lie in a plane.
[[nodiscard]] ConvexHull convexHull(std::span<const Vec3> points);

}  // namespace vantage
