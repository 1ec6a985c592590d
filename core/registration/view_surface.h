#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "registration/oriented_points.h"
#include "scanner/triangulation.h"

namespace vantage {

/// A place on a scanned surface, scanner coordinates.
struct SurfaceSample {
  Vec3 point = Vec3::Zero();      ///< [mm]
  Vec3 normal = Vec3::Zero();     ///< unit, toward the scanner
  Vec3 direction = Vec3::Zero();  ///< of the ray that measured next to it
  float confidence = 0.0F;        ///< cosine between normal and ray, (0, 1]
  bool inside = false;            ///< no corner of the triangle is on the border
};

/// The surface of one view, ready to be looked up along its own rays: the partner of a point is where the point's ray
/// meets the view's triangles. No search tree, no nearest neighbour. Immutable; queries may run on any thread. Copies
/// share their tables.
class ViewSurface {
 public:
  /// Keeps referring to both. @pre `view` was triangulated from an image with these rays
  ViewSurface(const ViewMesh& view, const RayGrid& rays);

  /// The surface seen along the ray through p (scanner coordinates); nothing where the view has none.
  /// @param position where to begin in the grid; set to where p was found.
  [[nodiscard]] std::optional<SurfaceSample> sample(const Vec3& p, std::optional<GridPosition>& position) const;

  /// Direction of the ray nearest to a place in the grid.
  [[nodiscard]] const Vec3& directionAt(const GridPosition& position) const {
    return rays_->ray(rays_->nearest(position)).direction;
  }

  /// Whether no ray within two of a place in the grid met surface; false at the grid's own rim.
  [[nodiscard]] bool isEmptyAround(const GridPosition& position) const;

  [[nodiscard]] const ViewMesh& view() const { return *view_; }
  /// About `most` of the vertices away from the border, scanner coordinates; all when there are fewer. They refer to
  /// what the surface refers to.
  [[nodiscard]] OrientedVertices pointsInside(std::size_t most = std::numeric_limits<std::size_t>::max()) const;

  /// Standard deviation of the samples across the surface, from how they scatter about their neighbours [mm].
  [[nodiscard]] double noise() const { return noise_; }

 private:
  const ViewMesh* view_;
  const RayGrid* rays_;
  std::shared_ptr<const std::vector<std::uint8_t>> cells_;  // which of its four possible triangles a grid cell has
  std::shared_ptr<const std::vector<Vec3>> normals_;
  double noise_ = 0.0;
};

}  // namespace vantage
