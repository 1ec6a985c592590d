#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scanner/view.h"

namespace vantage {

/// A ranging ray of a view that passes a point, in object coordinates.
struct RayPassage {
  std::uint32_t view = 0;
  GridPosition position;              ///< of the (interpolated) ray through the point
  std::size_t ray = 0;                ///< the ray of the grid that passes nearest to the point
  RangingRay line;                    ///< the ray through the point
  double depth = 0.0;                 ///< of the point along the line [mm]
  double spacing = 0.0;               ///< of the rays at the point: the local sample spacing [mm]
  std::optional<double> sampleDepth;  ///< along the line, of what `ray` measured [mm]; unset when it measured nothing
};

/// Tells which ranging rays of which views pass a point: the set R of Pito 1999, 4.3.2.
///
/// The paper sorts all rays into a coarse voxel partition. A ray grid can be asked directly where a point lies in it,
/// so this index keeps nothing but the poses: the answer is exact instead of good to a voxel, costs a few
/// interpolations and needs no memory that grows with rays times voxels. The rays of one view that pass a point are
/// neighbours and say the same, so one of each view stands for them.
class RayIndex {
 public:
  /// Keeps the span: the views must outlive the index.
  /// @throws InvalidInput for a view without an image.
  explicit RayIndex(std::span<const View> views);

  [[nodiscard]] std::size_t views() const { return views_.size(); }
  [[nodiscard]] const View& view(std::uint32_t v) const { return views_[v]; }

  /// The ray of a view through p (object coordinates); nothing where the view shoots none. `hint` speeds it up.
  [[nodiscard]] std::optional<RayPassage> through(std::uint32_t view, const Vec3& p,
                                                  const std::optional<GridPosition>& hint = {}) const;

  /// The ray that took a sample, as it passes the nearby point p.
  [[nodiscard]] RayPassage ofSample(std::uint32_t view, std::uint32_t sample, const Vec3& p) const;

  /// Depths along the passage's line of what its ray and the eight around it measured [mm].
  [[nodiscard]] std::vector<double> depthsAround(const RayPassage& passage) const;

  /// Positions of the receivers that watch the passage's ray; empty without triangulation.
  [[nodiscard]] std::vector<Vec3> receivers(const RayPassage& passage) const;

 private:
  [[nodiscard]] std::optional<double> sampleDepth(const RayPassage& passage, std::size_t ray) const;
  void complete(RayPassage& passage, const Vec3& p, const Vec3& inScanner) const;

  std::span<const View> views_;
  std::vector<Pose> T_scanner_object_;
};

}  // namespace vantage
