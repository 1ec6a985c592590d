#pragma once

#include <cstddef>
#include <span>

#include "integration/redundancy.h"

namespace vantage {

struct Seam {
  std::size_t viewTriangles = 0;        ///< triangles of the view that were added as they are
  std::size_t seamTriangles = 0;        ///< triangles that fill the gap
  std::vector<std::uint32_t> vertices;  ///< of the model, at the gap, ascending
};

/// Adds what was kept of the view to the model and closes the gap between their borders (Turk & Levoy 1994, 3.2) with
/// triangles between measured vertices: a constrained Delaunay triangulation in the view's grid, with both borders as
/// constraints, of which those triangles stay that lie in the gap, have no edge longer than a continuous surface
/// allows, and, unless they join the two borders, lie where the view has seen surface.
/// @throws Cancelled
[[nodiscard]] Seam stitch(ModelEditor& editor, std::span<const ProjectedVertex> projected, const GridSurface& surface,
                          const ViewCut& cut, const OverlapIndex& overlap, std::span<const View> views,
                          std::uint32_t newView, const ZipperOptions& options, const Progress& progress = {});

}  // namespace vantage
