#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vectors.h"
#include "scanner/ray_bounds.h"

namespace vantage {

/// A ranging ray r: a predetermined line along which the scanner measures a distance (Pito 1999, 4.1).
struct RangingRay {
  Vec3 origin;     ///< of the light source, scanner coordinates [mm]
  Vec3 direction;  ///< unit
};

/// A continuous place in a ray grid; whole numbers are the rays themselves.
struct GridPosition {
  double row = 0.0;
  double column = 0.0;
};

/// A scanner's ranging rays and receivers, in scanner coordinates: rows x columns rays, row-major, such that neighbours
/// in the grid are neighbours in space. All that the engine knows of a scanner's kind. Immutable.
class RayGrid {
 public:
  /// @param rays rows x columns rays, row-major, directions unit.
  /// @param receivers positions of the receiving optics, `receiversPerRay` for every ray, in order of the rays; empty
  ///        for a scanner without triangulation.
  /// @throws InvalidInput when the counts do not agree, the grid is smaller than 2 x 2, or a value is not finite.
  RayGrid(int rows, int columns, std::vector<RangingRay> rays, std::vector<Vec3> receivers, int receiversPerRay);

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] std::size_t size() const { return rays_.size(); }
  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  [[nodiscard]] const RangingRay& ray(std::size_t i) const { return rays_[i]; }

  /// Positions of the receivers that watch ray i; empty without triangulation.
  [[nodiscard]] std::span<const Vec3> receivers(std::size_t i) const {
    return {receivers_.data() + i * static_cast<std::size_t>(receiversPerRay_),
            static_cast<std::size_t>(receiversPerRay_)};
  }
  [[nodiscard]] bool triangulates() const { return receiversPerRay_ > 0; }

  /// The ray at a continuous position, interpolated between its neighbours (extrapolated outside of the grid).
  [[nodiscard]] RangingRay rayAt(const GridPosition& position) const;

  /// The ray nearest to a continuous position; the position is clamped to the grid.
  [[nodiscard]] std::size_t nearest(const GridPosition& position) const;

  /// Where in the grid the (interpolated) ray through p lies. `hint` speeds the search up; without one it begins
  /// everywhere.
  /// @return nothing when p is outside of the grid by more than half a cell, behind the rays, or not met by any.
  [[nodiscard]] std::optional<GridPosition> locate(const Vec3& p) const;
  [[nodiscard]] std::optional<GridPosition> locate(const Vec3& p, const GridPosition& hint) const;

  /// Distance from the ray nearest to p to its farthest grid neighbour, at p: the local sample spacing [mm].
  [[nodiscard]] double spacingAt(const Vec3& p, const GridPosition& position) const;

 private:
  int rows_;
  int columns_;
  int receiversPerRay_;
  std::vector<RangingRay> rays_;
  std::vector<Vec3> receivers_;
  std::vector<HalfSpace> bounds_;
};

}  // namespace vantage
