#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {

/// 1 for the vertices of edges that have one triangle only: MeshTopology::onBoundary of a manifold mesh, in one pass
/// and without its tables. A triangle that names a vertex twice has no edges.
/// @pre no triangle names a vertex that the mesh does not have
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const Mesh& mesh);

}  // namespace vantage
