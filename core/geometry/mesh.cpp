#include "geometry/mesh.h"

#include <string>

#include "base/errors.h"

namespace vantage {

void validate(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (v >= mesh.vertices.size())
        throw InvalidInput("triangle " + std::to_string(t) + " names vertex " + std::to_string(v) + " of a mesh with " +
                           std::to_string(mesh.vertices.size()) + " vertices");
}

Vec3 triangleNormal(const Mesh& mesh, const Triangle& t) {
  const Vec3 n = areaVector(mesh, t);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

std::vector<Vec3> computeVertexNormals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n = areaVector(mesh, t);
    for (const std::uint32_t v : t) normals[v] += n;
  }
  for (Vec3& n : normals) {
    const double length = n.norm();
    if (length > 0.0) n /= length;
  }
  return normals;
}

Mesh transformed(const Mesh& mesh, const Pose& T_target_mesh) {
  Mesh result = mesh;
  for (Vec3& v : result.vertices) v = T_target_mesh * v;
  return result;
}

Mesh quadMesh(std::span<const std::array<Vec3, 4>> quads) {
  Mesh mesh;
  for (const auto& quad : quads) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), quad.begin(), quad.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

std::vector<std::uint32_t> removeUnusedVertices(Mesh& mesh) {
  std::vector<std::uint32_t> newIndex(mesh.vertices.size(), kNoIndex);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) newIndex[v] = 0;
  std::uint32_t used = 0;
  for (std::size_t v = 0; v < newIndex.size(); ++v) {
    if (newIndex[v] == kNoIndex) continue;
    mesh.vertices[used] = mesh.vertices[v];
    newIndex[v] = used++;
  }
  mesh.vertices.resize(used);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = newIndex[v];
  return newIndex;
}

}  // namespace vantage
