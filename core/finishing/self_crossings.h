#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// How many pairs of triangles pass through each other. Triangles that share an edge, or only touch, do not count; nor
/// do triangles that lie in one plane.
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have; Cancelled
[[nodiscard]] std::size_t countCrossings(const Mesh& mesh, const Progress& progress = {});

/// For every triangle from `first` on how many others it passes through.
[[nodiscard]] std::vector<std::size_t> crossingsOf(const Mesh& mesh, std::uint32_t first,
                                                   const Progress& progress = {});

}  // namespace vantage
