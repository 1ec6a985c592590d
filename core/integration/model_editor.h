#pragma once

#include <cstdint>
#include <vector>

#include "integration/model.h"

namespace vantage {

/// A model under the knife. Triangles come and go in constant time; the corners around a vertex are a linked list. It
/// lets no two triangles use the same directed edge: what it holds is oriented consistently and has no edge with more
/// than two triangles. Vertices with several fans are possible until `resolveBowTies`.
///
/// Whether a vertex is on the boundary is known at once: its triangles sum up a hash of the vertex after it minus a
/// hash of the one before it, which cancel where every edge at the vertex has both its triangles.
class ModelEditor {
 public:
  /// @pre no directed edge is used twice
  /// @throws InvalidInput when the model's arrays disagree or a triangle names a vertex that is not there.
  explicit ModelEditor(Model model);

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Triangle& triangle(std::uint32_t t) const { return model_.mesh.triangles[t]; }
  [[nodiscard]] const Vec3& position(std::uint32_t v) const { return model_.mesh.vertices[v]; }
  [[nodiscard]] std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(model_.mesh.vertices.size()); }

  /// Counts removed triangles, too: ask `alive`.
  [[nodiscard]] std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(model_.mesh.triangles.size()); }
  [[nodiscard]] bool alive(std::uint32_t t) const { return alive_[t] != 0; }

  /// The triangle with the directed edge, or kNoIndex.
  [[nodiscard]] std::uint32_t triangleAt(std::uint32_t from, std::uint32_t to) const;
  /// Whether edge k of t has no triangle on its other side.
  [[nodiscard]] bool isBorderEdge(std::uint32_t t, int k) const {
    return onBoundary(triangle(t)[k]) && onBoundary(triangle(t)[(k + 1) % 3]) && neighbour(t, k) == kNoIndex;
  }
  /// The triangle on the other side of edge k of t, or kNoIndex.
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t t, int k) const {
    return triangleAt(triangle(t)[(k + 1) % 3], triangle(t)[k]);
  }
  /// Whether an edge at the vertex has only one triangle.
  [[nodiscard]] bool onBoundary(std::uint32_t vertex) const { return rim_[vertex] != 0; }
  /// Living triangles at a vertex, in no particular but a repeatable order.
  [[nodiscard]] std::vector<std::uint32_t> trianglesOf(std::uint32_t vertex) const;
  template <typename Visit>
  void visitTriangles(std::uint32_t vertex, const Visit& visit) const {
    for (std::uint32_t corner = first_[vertex]; corner != kNoIndex; corner = next_[corner]) visit(corner / 3);
  }

  /// @return the new vertex.
  std::uint32_t addVertex(const Vec3& position, float confidence, std::uint32_t view, std::uint32_t sample);
  void raiseConfidence(std::uint32_t vertex, float confidence);

  /// @return false, and nothing changes, when the triangle repeats a vertex or one of its directed edges is taken.
  bool addTriangle(const Triangle& triangle, std::uint32_t view);
  void removeTriangle(std::uint32_t t);
  /// Puts a removed triangle back in its place. @pre nothing has taken its directed edges meanwhile
  void restoreTriangle(std::uint32_t t);

  /// Removed triangles and unused vertices squeezed out, the order of the others kept.
  [[nodiscard]] Model take() &&;

 private:
  void attach(std::uint32_t corner);
  void detach(std::uint32_t corner);

  Model model_;
  std::vector<std::uint8_t> alive_;
  std::vector<std::uint32_t> first_;  // per vertex: a corner there
  std::vector<std::uint32_t> next_;   // per corner: the next one at its vertex
  std::vector<std::uint64_t> rim_;    // per vertex: the sum over its triangles, 0 inside
};

}  // namespace vantage
