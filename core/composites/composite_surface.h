#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// The surface of a composite as points with smoothed normals that know their neighbours: the point nearest to a place
/// is found by walking. Immutable; queries may run on any thread.
class CompositeSurface {
 public:
  /// @throws InvalidInput when a triangle names a vertex that the mesh does not have.
  explicit CompositeSurface(const Mesh& mesh);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Vec3& point(std::uint32_t i) const { return points_[i]; }    ///< [mm]
  [[nodiscard]] const Vec3& normal(std::uint32_t i) const { return normals_[i]; }  ///< unit, outward
  [[nodiscard]] bool isInside(std::uint32_t i) const { return inside_[i] != 0; }   ///< not on the border
  [[nodiscard]] std::span<const Vec3> points() const { return points_; }

  /// From a point on always to the neighbour that is nearest to p, until none is nearer.
  [[nodiscard]] std::uint32_t walkTo(const Vec3& p, std::uint32_t from) const;

  /// About `count` points away from the border, spread evenly over the area: every point stands for as much. Neighbours
  /// in the list are near each other.
  [[nodiscard]] std::vector<std::uint32_t> spread(std::size_t count) const;

  /// The same surface with every point moved on its own.
  /// @param motions @param motionOf per point: which of them
  [[nodiscard]] CompositeSurface moved(std::span<const Pose> motions, std::span<const std::uint32_t> motionOf) const;

 private:
  std::vector<Vec3> points_;
  std::vector<Vec3> normals_;
  std::vector<std::uint8_t> inside_;
  std::vector<double> area_;  // that a point stands for [mm^2]
  std::vector<std::uint32_t> firstNeighbour_;
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace vantage
