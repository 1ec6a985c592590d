#pragma once

#include <cstddef>

#include "geometry/mesh.h"

namespace vantage {

struct BoundingBox {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();

  void extend(const Vec3& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  [[nodiscard]] Vec3 size() const { return max - min; }
  [[nodiscard]] Vec3 centre() const { return 0.5 * (min + max); }
};

/// What a mesh is, in numbers.
struct MeshMeasures {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t boundaryEdges = 0;
  std::size_t boundaryLoops = 0;     ///< connected pieces of the boundary
  std::size_t nonManifoldEdges = 0;  ///< more than two triangles, or two that disagree in orientation
  std::size_t components = 0;        ///< pieces connected over edges
  double area = 0.0;                 ///< [mm^2]
  double meanEdgeLength = 0.0;       ///< [mm]
  BoundingBox box;                   ///< of the vertices that triangles use
};

[[nodiscard]] double area(const Mesh& mesh);

/// Box of all vertices; zero size at the origin for none.
[[nodiscard]] BoundingBox boundingBox(const Mesh& mesh);

/// @throws InvalidInput when a triangle names a vertex that the mesh does not have.
[[nodiscard]] MeshMeasures measure(const Mesh& mesh);

}  // namespace vantage
