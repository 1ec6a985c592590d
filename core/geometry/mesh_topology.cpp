#include "geometry/mesh_topology.h"

#include <algorithm>

namespace vantage {
namespace {

bool isDegenerate(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::uint32_t from(const Mesh& mesh, std::uint32_t corner) {
  return mesh.triangles[corner / 3][corner % 3];
}

std::uint32_t to(const Mesh& mesh, std::uint32_t corner) {
  return mesh.triangles[corner / 3][(corner % 3 + 1) % 3];
}

// One use of an edge by a triangle, filed under the edge's lower vertex.
struct EdgeUse {
  std::uint32_t high;
  std::uint32_t corner;  // 3 * triangle + k
};

// All uses of edges in the order of lower vertex, higher vertex, corner; `start` has the first use of every lower
// vertex.
struct EdgeUses {
  std::vector<EdgeUse> uses;
  std::vector<std::uint32_t> start;
};

EdgeUses sortedEdgeUses(const Mesh& mesh) {
  EdgeUses result;
  result.start.assign(mesh.vertices.size() + 1, 0);
  auto forEachEdge = [&](auto&& visit) {
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner)
      if (!isDegenerate(mesh.triangles[corner / 3])) visit(std::minmax({from(mesh, corner), to(mesh, corner)}), corner);
  };
  forEachEdge([&](const auto& edge, std::uint32_t /*corner*/) { ++result.start[edge.first + 1]; });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) result.start[v + 1] += result.start[v];
  result.uses.resize(result.start.back());
  std::vector<std::uint32_t> fill(result.start.begin(), result.start.end() - 1);
  forEachEdge([&](const auto& edge, std::uint32_t corner) { result.uses[fill[edge.first]++] = {edge.second, corner}; });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    std::sort(
        result.uses.begin() + result.start[v], result.uses.begin() + result.start[v + 1],
        [](const EdgeUse& a, const EdgeUse& b) { return a.high != b.high ? a.high < b.high : a.corner < b.corner; });
  return result;
}

}  // namespace

MeshTopology::MeshTopology(const Mesh& mesh)
    : neighbours_(3 * mesh.triangles.size(), kNoIndex), onBoundary_(mesh.vertices.size(), 0) {
  validate(mesh);
  pairEdges(mesh);
  collectIncidentTriangles(mesh);
}

void MeshTopology::pairEdges(const Mesh& mesh) {
  const auto [uses, start] = sortedEdgeUses(mesh);
  std::vector<std::uint32_t> boundaryCorners;
  for (std::uint32_t low = 0; low < mesh.vertices.size(); ++low) {
    for (std::uint32_t i = start[low], end = i; i < start[low + 1]; i = end) {
      while (end < start[low + 1] && uses[end].high == uses[i].high) ++end;
      const std::uint32_t corner = uses[i].corner;
      if (end - i == 2 && from(mesh, corner) != from(mesh, uses[i + 1].corner)) {
        neighbours_[corner] = uses[i + 1].corner / 3;
        neighbours_[uses[i + 1].corner] = corner / 3;
        continue;
      }
      if (end - i == 1) {
        boundaryCorners.push_back(corner);
      } else {
        ++nonManifoldEdges_;
      }
      onBoundary_[low] = onBoundary_[uses[i].high] = 1;
    }
  }
  std::sort(boundaryCorners.begin(), boundaryCorners.end());
  boundaryEdges_.reserve(boundaryCorners.size());
  for (const std::uint32_t corner : boundaryCorners)
    boundaryEdges_.push_back({from(mesh, corner), to(mesh, corner), corner / 3});
}

void MeshTopology::collectIncidentTriangles(const Mesh& mesh) {
  incidentStart_.assign(mesh.vertices.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) ++incidentStart_[v + 1];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) incidentStart_[v + 1] += incidentStart_[v];
  incident_.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> fill(incidentStart_.begin(), incidentStart_.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) incident_[fill[v]++] = t;
}

}  // namespace vantage
