#pragma once

#include <cstddef>
#include <span>

#include "integration/model_editor.h"

namespace vantage {

/// Whether the triangles at a vertex hang together over edges at it; true for none.
[[nodiscard]] bool isSingleFan(const ModelEditor& editor, std::uint32_t vertex);

/// Leaves every vertex on the boundary, and those named, a single fan of triangles: of several the largest stays (of
/// equal ones that with the triangle added first), the others are removed, and so on where that makes new bow ties.
/// @return how many triangles went.
std::size_t resolveBowTies(ModelEditor& editor, std::span<const std::uint32_t> vertices);

/// Removes connected pieces of fewer than `minTriangles` triangles.
/// @pre no bow ties
/// @return how many triangles went.
std::size_t removeIslands(ModelEditor& editor, int minTriangles);

}  // namespace vantage
