#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "integration/exact_plane.h"
#include "integration/grid_surface.h"
#include "integration/model.h"
#include "integration/zipper_options.h"

namespace vantage {

/// How a vertex of the model lies to a view's surface.
enum class Contact : std::uint8_t {
  Unseen,  ///< outside of the grid or turned away from the scanner
  Apart,   ///< in the grid, at another depth or where the view has no surface
  Near,    ///< beside the view's surface, on its continuation
  On,      ///< on the view's surface
};

struct ProjectedVertex {
  PlanePoint place;  ///< in the view's grid, unless Unseen
  Contact contact = Contact::Unseen;
  bool refuted = false;     ///< the view has seen through the vertex to surface farther away than the tolerance
  float confidence = 0.0F;  ///< the view's, where On
  float quality = 0.0F;     ///< the view's, where On or refuted: GridSurface::quality
};

/// Says of single places how they lie to a view's surface.
class VertexProjector {
 public:
  VertexProjector(const GridSurface& surface, const ZipperOptions& options);

  /// Of a place and the unit normal of the surface there, in scanner coordinates. `hint` is where the place before was
  /// found and becomes where this one is.
  [[nodiscard]] ProjectedVertex project(const Vec3& p, const Vec3& normal, std::optional<GridPosition>& hint) const;

  /// Two surfaces that are no farther apart than this are one [mm].
  [[nodiscard]] double tolerance() const { return tolerance_; }

 private:
  [[nodiscard]] double heightAbove(const GridContact& contact, const Vec3& p) const;
  [[nodiscard]] bool nearSurface(const Vec3& p, const Vec3& normal, const GridPosition& position) const;

  const GridSurface& surface_;
  double tolerance_;
  double minNormalCosine_;
  double minRayCosine_;
};

/// Every vertex of the model seen from a view. A vertex is On when its ray passes a triangle of the view's mesh, its
/// distance from the triangle's plane is within the tolerance and the normals agree; Near when it passes none but the
/// nearest sample of the mesh, at most `kNearCells` away, has a tangent plane of which the same is true.
[[nodiscard]] std::vector<ProjectedVertex> projectModel(const Model& model, const GridSurface& surface,
                                                        const ZipperOptions& options, const Progress& progress);

inline constexpr int kNearCells = 2;

}  // namespace vantage
