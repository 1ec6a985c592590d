#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Indices of a triangle's vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

inline constexpr std::uint32_t kNoIndex = 0xffffffffU;

/// A triangle mesh: positions [mm] and index triples. A plain value; laws such as "manifold" are checked by measures.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  [[nodiscard]] bool empty() const { return triangles.empty(); }
};

/// @throws InvalidInput when a triangle names a vertex that the mesh does not have.
void validate(const Mesh& mesh);

/// Twice the area vector of a triangle: its direction is the outward normal.
[[nodiscard]] inline Vec3 areaVector(const Mesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
}

/// Unit normal of a triangle; zero when it is degenerate.
[[nodiscard]] Vec3 triangleNormal(const Mesh& mesh, const Triangle& t);

[[nodiscard]] inline Vec3 triangleCentre(const Mesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

[[nodiscard]] inline double triangleArea(const Mesh& mesh, const Triangle& t) {
  return 0.5 * areaVector(mesh, t).norm();
}

/// Unit normal per vertex: mean of the adjacent triangles' normals weighted by area; zero for isolated vertices.
[[nodiscard]] std::vector<Vec3> computeVertexNormals(const Mesh& mesh);

/// The mesh moved by a rigid motion.
[[nodiscard]] Mesh transformed(const Mesh& mesh, const Pose& T_target_mesh);

/// Separate quads as a mesh: triangles 2 i and 2 i + 1 are quad i.
[[nodiscard]] Mesh quadMesh(std::span<const std::array<Vec3, 4>> quads);

/// Drops vertices that no triangle uses, keeping the order of the others.
/// @return for every old vertex its new index, or kNoIndex.
std::vector<std::uint32_t> removeUnusedVertices(Mesh& mesh);

}  // namespace vantage
