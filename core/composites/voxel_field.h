#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "geometry/vectors.h"
#include "scanner/view.h"

namespace vantage {

/// The space about a composite in cubes: which point of the surface is nearest to each, and whether rays of the scanner
/// passed through it. For looking up many places fast; what it says is as coarse as the cubes.
class VoxelField {
 public:
  /// @param points of the surface, at least one @param views whose rays looked into the space
  /// @param side of the cubes [mm] @param margin of cubes around the points [mm]; both above 0
  /// @throws Cancelled
  VoxelField(std::span<const Vec3> points, std::span<const View> views, double side, double margin,
             const Progress& progress);

  /// Index of the point that is nearest to the middle of the cube around p; nothing outside of the field.
  [[nodiscard]] std::optional<std::uint32_t> nearest(const Vec3& p) const {
    const auto cube = cubeOf(p);
    if (!cube) return std::nullopt;
    return nearest_[*cube];
  }

  /// Whether two rays or more passed through the cube around p, which lies off the surface.
  [[nodiscard]] bool isFree(const Vec3& p) const {
    const auto cube = cubeOf(p);
    return cube && free_[*cube] != 0;
  }

  [[nodiscard]] double side() const { return side_; }

 private:
  [[nodiscard]] std::optional<std::size_t> cubeOf(const Vec3& p) const {
    const Vec3 place = (p - origin_) / side_;
    if (!(place.minCoeff() >= 0.0) || place.x() >= counts_[0] || place.y() >= counts_[1] || place.z() >= counts_[2])
      return std::nullopt;
    return index(static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z()));
  }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * counts_[1] + y) * counts_[0] + x;
  }
  [[nodiscard]] Vec3 middle(int x, int y, int z) const { return origin_ + side_ * Vec3(x + 0.5, y + 0.5, z + 0.5); }

  void findNearest(std::span<const Vec3> points, const Progress& progress);
  void sweep(std::span<const Vec3> points, bool forward, std::vector<float>& distance, const Progress& progress);
  void countRays(std::span<const View> views, const Progress& progress);
  void countRay(const Vec3& origin, const Vec3& direction, double range);

  double side_;
  Vec3 origin_ = Vec3::Zero();
  std::array<int, 3> counts_{};
  std::vector<std::uint32_t> nearest_;
  std::vector<std::uint8_t> free_;  // rays while they are counted
};

}  // namespace vantage
