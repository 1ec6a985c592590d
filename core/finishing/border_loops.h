#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {

/// An opening of a surface.
struct BorderLoop {
  /// Its vertices, counter-clockwise about the opening seen from outside: what fills it has the edges from one to the
  /// next, and from the last to the first.
  std::vector<std::uint32_t> vertices;
  double length = 0.0;  ///< [mm]
  double width = 0.0;   ///< greatest distance between two of the vertices [mm]
};

/// The openings of a surface, in order of the first boundary edge of each. The border is followed along the surface:
/// where two fans of triangles meet in a vertex, every fan is passed by itself.
/// @pre no edge has more than two triangles, and neighbours agree in orientation
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have
[[nodiscard]] std::vector<BorderLoop> borderLoops(const Mesh& mesh);

/// Gives every fan of triangles a vertex of its own where several meet in one vertex (a bow tie). New vertices follow
/// the old ones. @return for every new vertex the one at whose place it is
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have
std::vector<std::uint32_t> splitBowTies(Mesh& mesh);

/// How many vertices have several fans.
[[nodiscard]] std::size_t countBowTies(const Mesh& mesh);

}  // namespace vantage
