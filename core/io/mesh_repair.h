#pragma once

#include <cstddef>
#include <string>

#include "base/progress.h"
#include "io/polygon_soup.h"

namespace vantage {

/// What had to be done to a mesh file before it could be scanned.
struct MeshRepair {
  std::size_t polygonsCut = 0;           ///< polygons with more than three corners, now triangles
  std::size_t droppedMissingVertex = 0;  ///< polygons that name a vertex (in OBJ also a normal ...) that does not exist
  std::size_t droppedNotFinite = 0;      ///< polygons with a coordinate that is NaN, infinite or beyond kMaxMeshCoordinate
  std::size_t droppedDegenerate = 0;     ///< polygons with fewer than three corners, triangles without an area
  std::size_t droppedDuplicate = 0;      ///< triangles that repeat another, corner by corner
  std::size_t mergedVertices = 0;        ///< vertices at the very place of another
  std::size_t unusedVertices = 0;        ///< vertices without a triangle
  std::size_t flippedTriangles = 0;      ///< turned round so that neighbours agree and the outside is outside
  std::size_t bytesLeftOver = 0;         ///< of the file, behind what it says that it holds
  std::size_t openSeams = 0;             ///< edges along which no orientation agrees: the surface has one side only

  [[nodiscard]] std::size_t dropped() const {
    return droppedMissingVertex + droppedNotFinite + droppedDegenerate + droppedDuplicate;
  }
  [[nodiscard]] bool nothing() const {
    return dropped() + polygonsCut + mergedVertices + unusedVertices + flippedTriangles + openSeams + bytesLeftOver ==
           0;
  }
};

/// No object is larger; such a coordinate is a damaged number.
inline constexpr double kMaxMeshCoordinate = 1e9;

/// Makes a mesh of what stood in a file: drops polygons that cannot be surface, cuts the others into triangles, makes
/// one vertex of those at exactly the same place, drops triangles without an area (also in single precision) and
/// repeated ones, orients the rest (see orientOutward) and leaves out unused vertices. Vertices and triangles keep
/// their order.
/// @throws Cancelled
[[nodiscard]] Mesh repairedMesh(PolygonSoup soup, MeshRepair& repair, const Progress& progress = {});

/// "12 triangles without an area dropped, 3 vertices merged"; empty when nothing was done.
[[nodiscard]] std::string describe(const MeshRepair& repair);

}  // namespace vantage
