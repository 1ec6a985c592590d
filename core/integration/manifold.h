#pragma once

#include <cstddef>

#include "integration/model_editor.h"

namespace vantage {

/// Whether the triangles at a vertex hang together over edges at it; true for none.
[[nodiscard]] bool isSingleFan(const ModelEditor& editor, std::uint32_t vertex);

/// Leaves every vertex a single fan of triangles: of several the largest stays (of equal ones that with the triangle
/// added first), the others are removed, and so on where that makes new bow ties.
/// @return how many triangles went.
std::size_t resolveBowTies(ModelEditor& editor);

/// Removes pieces, connected over edges, of fewer than `minTriangles` triangles.
/// @return how many triangles went.
std::size_t removeIslands(ModelEditor& editor, int minTriangles);

}  // namespace vantage
