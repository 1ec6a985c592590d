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
  std::size_t bytesLeftOver = 0;       ///< of the file, behind what it says that it holds

  void endPolygon() { ends.push_back(corners.size()); }
  [[nodiscard]] std::span<const std::uint32_t> polygon(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return {corners.data() + begin, ends[i] - begin};
  }
};

/// Cuts a polygon of at least three existing points into triangles, appended to `triangles`, that keep its orientation:
/// ears are clipped in the plane of its area vector, in time that grows with its corners times those where it turns
/// inward. A polygon that has no ear left, as it crosses itself, becomes a fan.
void triangulatePolygon(std::span<const Vec3> points, std::span<const std::uint32_t> polygon,
                        std::vector<Triangle>& triangles);

}  // namespace vantage
