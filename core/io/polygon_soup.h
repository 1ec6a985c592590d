#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// What stands in a mesh file before anybody has checked it: points, and polygons over them. Corners may name points
/// that do not exist (kNoIndex for "none at all").
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> corners;  ///< of all polygons, one after the other
  std::vector<std::size_t> ends;       ///< per polygon: where its corners end

  void endPolygon() { ends.push_back(corners.size()); }
  [[nodiscard]] std::span<const std::uint32_t> polygon(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return {corners.data() + begin, ends[i] - begin};
  }
};

/// Cuts a polygon of at least three existing points into triangles, appended to `triangles`, that keep its orientation.
/// Up to 64 corners are cut by clipping ears in the plane of its area vector; a polygon that has no ear left (it
/// crosses itself), or has more corners, becomes a fan.
void triangulatePolygon(std::span<const Vec3> points, std::span<const std::uint32_t> polygon,
                        std::vector<Triangle>& triangles);

}  // namespace vantage
