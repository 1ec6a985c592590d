#include "geometry/measures.h"

#include <cstdint>
#include <numeric>
#include <vector>

#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

// Union-find over indices.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

std::size_t countComponents(const Mesh& mesh, const MeshTopology& topology) {
  DisjointSets sets(mesh.triangles.size());
  std::size_t components = mesh.triangles.size();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t other = topology.neighbour(t, k);
      if (other == kNoIndex || sets.find(t) == sets.find(other)) continue;
      sets.join(t, other);
      --components;
    }
  }
  return components;
}

// Every vertex of the boundary is a piece of its own until an edge joins it to another.
std::size_t countBoundaryLoops(const Mesh& mesh, const MeshTopology& topology) {
  DisjointSets sets(mesh.vertices.size());
  std::vector<std::uint8_t> seen(mesh.vertices.size(), 0);
  std::size_t loops = 0;
  for (const BoundaryEdge& e : topology.boundaryEdges()) {
    for (const std::uint32_t v : {e.from, e.to}) {
      if (seen[v] == 0) ++loops;
      seen[v] = 1;
    }
    if (sets.find(e.from) == sets.find(e.to)) continue;
    sets.join(e.from, e.to);
    --loops;
  }
  return loops;
}

}  // namespace

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) sum += triangleArea(mesh, t);
  return sum;
}

BoundingBox boundingBox(const Mesh& mesh) {
  BoundingBox box;
  if (mesh.vertices.empty()) return box;
  box.min = box.max = mesh.vertices.front();
  for (const Vec3& v : mesh.vertices) box.extend(v);
  return box;
}

MeshMeasures measure(const Mesh& mesh) {
  const MeshTopology topology(mesh);
  MeshMeasures m;
  m.vertices = mesh.vertices.size();
  m.triangles = mesh.triangles.size();
  m.boundaryEdges = topology.boundaryEdges().size();
  m.boundaryLoops = countBoundaryLoops(mesh, topology);
  m.nonManifoldEdges = topology.nonManifoldEdges();
  m.components = countComponents(mesh, topology);
  m.area = area(mesh);
  double length = 0.0;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) length += (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm();
  if (!mesh.triangles.empty()) m.meanEdgeLength = length / (3.0 * static_cast<double>(mesh.triangles.size()));
  if (!mesh.triangles.empty()) m.box.min = m.box.max = mesh.vertices[mesh.triangles[0][0]];
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) m.box.extend(mesh.vertices[v]);
  return m;
}

}  // namespace vantage
