#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// What a triangulation of a loop goes on from.
struct LoopSurroundings {
  /// Unit normal of the surface beside the edge from vertex i of the loop to the next; zero where there is none.
  std::vector<Vec3> normals;
  /// Whether two vertices of the loop, by their places in it, are joined by an edge of the surface already.
  std::function<bool(std::size_t, std::size_t)> joined;
};

/// Triangles between the vertices of a closed polygon: of all ways to cut it up that with the smallest greatest angle
/// between neighbouring triangles, those beside the polygon included, and of those that with the least area (Barequet &
/// Sharir 1995; Liepa 2003). Chords that the surface has already are not used. Polygons of very many vertices are cut
/// up between evenly taken ones first.
/// @param points of the vertices in order; those of a triangle are counter-clockwise as the polygon is
/// @return places in the polygon; empty when there is no way
/// @throws Cancelled
[[nodiscard]] std::vector<Triangle> triangulateLoop(std::span<const Vec3> points, const LoopSurroundings& surroundings,
                                                    const Progress& progress = {});

}  // namespace vantage
