#pragma once

#include "io/file_bytes.h"
#include "io/polygon_soup.h"

namespace vantage {

/// Reads a mesh from PLY with the elements vertex {x y z} and, unless it holds points only, face {vertex_indices |
/// vertex_index} or tristrips {vertex_indices}. What only concerns one polygon (a vertex that does not exist, a
/// coordinate that is no number) is left in the soup for the repair to drop and count.
/// @throws InvalidInput naming file, line (or byte) and what was expected, when the file is damaged or something else
/// @throws Cancelled
[[nodiscard]] PolygonSoup readPlySoup(const FileBytes& file, const Progress& progress = {});

}  // namespace vantage
