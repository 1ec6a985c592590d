#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {

/// What hangs together over edges.
struct SurfacePiece {
  std::vector<std::uint32_t> triangles;  ///< ascending
  double area = 0.0;                     ///< [mm^2]
};

/// The pieces of a surface, the largest first; of equal ones that with the lowest triangle.
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have
[[nodiscard]] std::vector<SurfacePiece> piecesOf(const Mesh& mesh);

/// 1 for the triangles of pieces up to an area [mm^2]; the largest piece is never among them.
[[nodiscard]] std::vector<std::uint8_t> loosePieces(const Mesh& mesh, double largestArea);

/// The volume that a closed piece encloses [mm^3]; negative when it is inside out, without meaning when it is open.
[[nodiscard]] double signedVolume(const Mesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace vantage
