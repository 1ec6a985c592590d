#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {

/// A boundary edge, directed as in its only triangle: the surface lies to the left of from -> to seen from outside.
struct BoundaryEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
};

/// Adjacency of a triangle mesh: for the k-th edge of a triangle (from its vertex k to vertex k+1) the triangle on the
/// other side. Edges with more than two triangles, or with two that disagree in orientation, count as non-manifold.
/// A triangle that names a vertex twice has no edges.
class MeshTopology {
 public:
  /// @throws InvalidInput when a triangle names a vertex that the mesh does not have.
  explicit MeshTopology(const Mesh& mesh);

  /// The neighbour of `triangle` across its edge k in 0..2; kNoIndex on the boundary and at non-manifold edges.
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t triangle, int k) const { return neighbours_[3 * triangle + k]; }

  /// Edges with exactly one triangle, in order of triangle and edge.
  [[nodiscard]] const std::vector<BoundaryEdge>& boundaryEdges() const { return boundaryEdges_; }

  /// 1 for the vertices of boundary or non-manifold edges.
  [[nodiscard]] const std::vector<std::uint8_t>& onBoundary() const { return onBoundary_; }

  [[nodiscard]] std::size_t nonManifoldEdges() const { return nonManifoldEdges_; }

  /// Triangles around a vertex, ascending.
  [[nodiscard]] std::span<const std::uint32_t> trianglesOf(std::uint32_t vertex) const {
    return {incident_.data() + incidentStart_[vertex], incident_.data() + incidentStart_[vertex + 1]};
  }

 private:
  void pairEdges(const Mesh& mesh);
  void collectIncidentTriangles(const Mesh& mesh);

  std::vector<std::uint32_t> neighbours_;
  std::vector<BoundaryEdge> boundaryEdges_;
  std::vector<std::uint8_t> onBoundary_;
  std::vector<std::uint32_t> incidentStart_;
  std::vector<std::uint32_t> incident_;
  std::size_t nonManifoldEdges_ = 0;
};

}  // namespace vantage
