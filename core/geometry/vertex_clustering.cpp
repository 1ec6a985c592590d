#include "geometry/vertex_clustering.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "geometry/mesh_border.h"

namespace vantage {
namespace {

// Triangles of a surface per area of a side of the cubes that it passes.
constexpr double kTrianglesPerSide = 3.0;

// 0..5: the side of a cube that a normal points through.
std::uint64_t sideOf(const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::uint64_t>(axis) + (normal[axis] < 0.0 ? 1 : 0);
}

struct Member {
  std::uint64_t cluster;
  std::uint32_t vertex;
};

// The vertices inside the surface by the cube and the side that they belong to.
std::vector<Member> membersOf(const Mesh& mesh, const std::vector<std::uint8_t>& border, double cube) {
  const std::vector<Vec3> normals = computeVertexNormals(mesh);
  constexpr double kMostCubes = 1 << 20;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Vec3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  cube = std::max(cube, (high - low).maxCoeff() / kMostCubes);
  std::vector<Member> members;
  members.reserve(mesh.vertices.size());
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (border[v] != 0) continue;
    std::uint64_t cluster = sideOf(normals[v]);
    for (int k = 0; k < 3; ++k)
      cluster = (cluster << 20U) |
                static_cast<std::uint64_t>(std::min((mesh.vertices[v][k] - low[k]) / cube, kMostCubes - 1.0));
    members.push_back({cluster, v});
  }
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return std::pair(a.cluster, a.vertex) < std::pair(b.cluster, b.vertex);
  });
  return members;
}

std::uint32_t nearestToMean(const Mesh& mesh, const Member* begin, const Member* end) {
  Vec3 mean = Vec3::Zero();
  for (const Member* m = begin; m != end; ++m) mean += mesh.vertices[m->vertex];
  mean /= static_cast<double>(end - begin);
  const Member* nearest = std::min_element(begin, end, [&](const Member& a, const Member& b) {
    return (mesh.vertices[a.vertex] - mean).squaredNorm() < (mesh.vertices[b.vertex] - mean).squaredNorm();
  });
  return nearest->vertex;
}

// For every vertex the one that stands for it.
std::vector<std::uint32_t> representatives(const Mesh& mesh, const std::vector<Member>& members) {
  std::vector<std::uint32_t> standing(mesh.vertices.size());
  for (std::uint32_t v = 0; v < standing.size(); ++v) standing[v] = v;
  for (std::size_t i = 0, end = i; i < members.size(); i = end) {
    while (end < members.size() && members[end].cluster == members[i].cluster) ++end;
    const std::uint32_t nearest = nearestToMean(mesh, members.data() + i, members.data() + end);
    for (std::size_t k = i; k < end; ++k) standing[members[k].vertex] = nearest;
  }
  return standing;
}

// The lowest corner first.
Triangle rotated(const Triangle& t) {
  const auto lowest = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[lowest], t[(lowest + 1) % 3], t[(lowest + 2) % 3]};
}

}  // namespace

double cubeFor(double area, std::size_t triangles) {
  return std::sqrt(kTrianglesPerSide * area / static_cast<double>(std::max<std::size_t>(triangles, 1)));
}

Mesh clustered(const Mesh& mesh, double cube, const Progress& progress) {
  progress.checkpoint(0.0);
  if (!(cube > 0.0)) throw InvalidInput("cubes of " + std::to_string(cube) + " mm hold no vertices");
  validate(mesh);
  const std::vector<std::uint8_t> border = borderVertices(mesh);
  progress.checkpoint(0.2);
  const std::vector<Member> members = membersOf(mesh, border, cube);
  progress.checkpoint(0.6);
  const std::vector<std::uint32_t> standing = representatives(mesh, members);
  progress.checkpoint(0.8);
  Mesh result;
  for (const Triangle& t : mesh.triangles) {
    const Triangle s{standing[t[0]], standing[t[1]], standing[t[2]]};
    if (s[0] != s[1] && s[1] != s[2] && s[2] != s[0]) result.triangles.push_back(rotated(s));
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  result.triangles.erase(std::unique(result.triangles.begin(), result.triangles.end()), result.triangles.end());
  result.vertices = mesh.vertices;
  removeUnusedVertices(result);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
