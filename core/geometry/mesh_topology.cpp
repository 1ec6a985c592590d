#include "geometry/mesh_topology.h"

#include <algorithm>

namespace vantage {
namespace {

// One use of an undirected edge by a triangle.
struct EdgeUse {
  std::uint64_t key;
  std::uint32_t corner;  // 3 * triangle + k
};

}  // namespace

MeshTopology::MeshTopology(const Mesh& mesh)
    : neighbours_(3 * mesh.triangles.size(), kNoIndex),
      onBoundary_(mesh.vertices.size(), 0),
      incidentStart_(mesh.vertices.size() + 1, 0) {
  std::vector<EdgeUse> uses;
  uses.reserve(neighbours_.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint64_t a = mesh.triangles[t][k];
      const std::uint64_t b = mesh.triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b) << 32 | std::max(a, b), 3 * t + k});
      ++incidentStart_[a + 1];
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return a.key != b.key ? a.key < b.key : a.corner < b.corner; });

  auto from = [&](std::uint32_t corner) { return mesh.triangles[corner / 3][corner % 3]; };
  std::vector<std::uint32_t> boundaryCorners;
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].key == uses[i].key) ++end;
    const auto count = end - i;
    if (count == 1) {
      boundaryCorners.push_back(uses[i].corner);
    } else if (count == 2 && from(uses[i].corner) != from(uses[i + 1].corner)) {
      neighbours_[uses[i].corner] = uses[i + 1].corner / 3;
      neighbours_[uses[i + 1].corner] = uses[i].corner / 3;
    } else {
      ++nonManifoldEdges_;
    }
    if (count != 2 || from(uses[i].corner) == from(uses[i + 1].corner)) {
      onBoundary_[uses[i].key >> 32] = 1;
      onBoundary_[uses[i].key & 0xffffffffU] = 1;
    }
    i = end;
  }
  std::sort(boundaryCorners.begin(), boundaryCorners.end());
  boundaryEdges_.reserve(boundaryCorners.size());
  for (const std::uint32_t corner : boundaryCorners) {
    const std::uint32_t t = corner / 3;
    boundaryEdges_.push_back({from(corner), mesh.triangles[t][(corner % 3 + 1) % 3], t});
  }

  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) incidentStart_[v + 1] += incidentStart_[v];
  incident_.resize(neighbours_.size());
  std::vector<std::uint32_t> fill(incidentStart_.begin(), incidentStart_.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) incident_[fill[v]++] = t;
}

}  // namespace vantage
