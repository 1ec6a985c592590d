#pragma once

#include <cstddef>

#include "integration/grid_surface.h"
#include "integration/model_editor.h"
#include "integration/zipper_options.h"

namespace vantage {

/// Closes small holes with triangles between the vertices around them, holes of few edges that need no long chord,
/// inside of what was seen; where the surface around a hole overlaps itself, its innermost triangles are replaced, too.
/// The new view decides where it looks at the hole: closed where its surface passes through, left open where it sees
/// farther. Elsewhere a hole is closed when it lies between several views, or when it is a single triangle.
/// @pre no bow ties
/// @return how many holes were closed.
std::size_t closeSmallHoles(ModelEditor& editor, const GridSurface& surface, std::uint32_t newView,
                            const ZipperOptions& options);

}  // namespace vantage
