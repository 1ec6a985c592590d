#pragma once

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// A coarser mesh in a time that grows with the size of the input only: of the vertices in a cube whose normals point
/// along the same side of it, the one nearest to their mean stands for all. Vertices on a border stay, sides of a thin
/// wall do not grow together, and no surface moves by more than the diagonal of a cube. The result need not be
/// manifold, and here and there a triangle is folded over: it is for looking at, not for walking over.
/// @param cube side of the cubes [mm], above 0
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have, or for another side; Cancelled
[[nodiscard]] Mesh clustered(const Mesh& mesh, double cube, const Progress& progress = {});

/// Side of the cubes that leaves about so many triangles of a surface with this area [mm].
[[nodiscard]] double cubeFor(double area, std::size_t triangles);

}  // namespace vantage
