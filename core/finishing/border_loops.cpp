#include "finishing/border_loops.h"

#include <algorithm>

#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

// Of loops with more vertices than this the width is that of so many of them, evenly taken.
constexpr std::size_t kWidthVertices = 4096;

int cornerOf(const Triangle& t, std::uint32_t vertex) {
  return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
}

// The boundary edge of the fan of `edge` at its end: the next one along the border.
BoundaryEdge nextEdge(const Mesh& mesh, const MeshTopology& topology, const BoundaryEdge& edge) {
  std::uint32_t triangle = edge.triangle;
  for (;;) {
    const Triangle& t = mesh.triangles[triangle];
    const int k = cornerOf(t, edge.to);  // the edge that leaves `to`
    const std::uint32_t other = topology.neighbour(triangle, k);
    if (other == kNoIndex) return {edge.to, t[(k + 1) % 3], triangle};
    triangle = other;
  }
}

double widthOf(const Mesh& mesh, const std::vector<std::uint32_t>& loop) {
  const std::size_t step = loop.size() / kWidthVertices + 1;
  double squared = 0.0;
  for (std::size_t i = 0; i < loop.size(); i += step)
    for (std::size_t j = i + step; j < loop.size(); j += step)
      squared = std::max(squared, (mesh.vertices[loop[i]] - mesh.vertices[loop[j]]).squaredNorm());
  return std::sqrt(squared);
}

// The fans at a vertex: each a list of triangles.
std::vector<std::vector<std::uint32_t>> fansAt(const Mesh& mesh, const MeshTopology& topology, std::uint32_t vertex) {
  std::vector<std::uint32_t> left(topology.trianglesOf(vertex).begin(), topology.trianglesOf(vertex).end());
  std::vector<std::vector<std::uint32_t>> fans;
  while (!left.empty()) {
    std::vector<std::uint32_t> fan{left.front()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const int k = cornerOf(mesh.triangles[fan[i]], vertex);
      for (const int edge : {k, (k + 2) % 3}) {
        const auto other = std::find(left.begin(), left.end(), topology.neighbour(fan[i], edge));
        if (other == left.end()) continue;
        fan.push_back(*other);
        left.erase(other);
      }
    }
    fans.push_back(std::move(fan));
  }
  return fans;
}

}  // namespace

std::vector<BorderLoop> borderLoops(const Mesh& mesh) {
  const MeshTopology topology(mesh);
  const std::vector<BoundaryEdge>& edges = topology.boundaryEdges();
  // Boundary edges are in order of triangle; a triangle has up to three.
  std::vector<std::uint8_t> passed(3 * mesh.triangles.size(), 0);
  const auto place = [&](const BoundaryEdge& e) {
    return 3 * static_cast<std::size_t>(e.triangle) +
           static_cast<std::size_t>(cornerOf(mesh.triangles[e.triangle], e.from));
  };
  std::vector<BorderLoop> loops;
  for (const BoundaryEdge& first : edges) {
    BorderLoop loop;
    for (BoundaryEdge edge = first; passed[place(edge)] == 0; edge = nextEdge(mesh, topology, edge)) {
      passed[place(edge)] = 1;
      loop.vertices.push_back(edge.to);
      loop.length += (mesh.vertices[edge.from] - mesh.vertices[edge.to]).norm();
    }
    if (loop.vertices.empty()) continue;
    std::reverse(loop.vertices.begin(), loop.vertices.end());
    loop.width = widthOf(mesh, loop.vertices);
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<std::uint32_t> splitBowTies(Mesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<std::uint32_t> origins;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t v = 0; v < count; ++v) {
    if (topology.trianglesOf(v).size() < 2) continue;
    const auto fans = fansAt(mesh, topology, v);
    for (std::size_t f = 1; f < fans.size(); ++f) {
      const auto added = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(mesh.vertices[v]);
      origins.push_back(v);
      for (const std::uint32_t t : fans[f]) std::replace(mesh.triangles[t].begin(), mesh.triangles[t].end(), v, added);
    }
  }
  return origins;
}

std::size_t countBowTies(const Mesh& mesh) {
  const MeshTopology topology(mesh);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    if (topology.trianglesOf(v).size() > 1 && fansAt(mesh, topology, v).size() > 1) ++count;
  return count;
}

}  // namespace vantage
