#pragma once

#include <cstdint>
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

/// Every vertex of the model seen from a view. A vertex is On when its ray passes a triangle of the view's mesh, its
/// distance from the triangle's plane is within the tolerance and the normals agree; Near when it passes none but the
/// nearest sample of the mesh, at most `kNearCells` away, has a tangent plane of which the same is true.
[[nodiscard]] std::vector<ProjectedVertex> projectModel(const Model& model, const GridSurface& surface,
                                                        const ZipperOptions& options, const Progress& progress);

inline constexpr int kNearCells = 2;

}  // namespace vantage
