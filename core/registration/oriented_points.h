#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Points of a surface with unit normals and confidences (0, 1], all in one frame.
struct OrientedPoints {
  std::vector<Vec3> points;  ///< [mm]
  std::vector<Vec3> normals;
  std::vector<float> confidence;

  [[nodiscard]] std::size_t size() const { return points.size(); }

  /// Adds the points of `other`, moved.
  void append(const OrientedPoints& other, const Pose& T_this_other);
};

/// About `count` of the points, spread evenly; all when there are fewer.
[[nodiscard]] OrientedPoints thinnedPoints(const OrientedPoints& points, std::size_t count);

/// Indices 0..size-1.
[[nodiscard]] std::vector<std::uint32_t> allIndices(std::size_t size);

/// About `count` of the indices, chosen by a hash of each so that no grid pattern shows; all when there are fewer.
[[nodiscard]] std::vector<std::uint32_t> thinned(std::vector<std::uint32_t> indices, std::size_t count);

}  // namespace vantage
