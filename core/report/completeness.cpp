#include "report/completeness.h"

#include <vector>

#include "geometry/measures.h"
#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

// Vertices of the boundary, loop by loop. Where two loops meet in a vertex they are cut there in the order of edges.
std::vector<std::vector<std::uint32_t>> openings(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<std::vector<std::uint32_t>> leaving(mesh.vertices.size());
  for (const BoundaryEdge& edge : topology.boundaryEdges()) leaving[edge.from].push_back(edge.to);
  std::vector<std::vector<std::uint32_t>> loops;
  for (const BoundaryEdge& edge : topology.boundaryEdges()) {
    std::vector<std::uint32_t> loop;
    for (std::uint32_t v = edge.from; !leaving[v].empty();) {
      loop.push_back(v);
      const std::uint32_t next = leaving[v].back();
      leaving[v].pop_back();
      v = next;
    }
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

// Of a fan from the middle of a loop [mm^2].
double spannedArea(const Mesh& mesh, const std::vector<std::uint32_t>& loop) {
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t v : loop) middle += mesh.vertices[v];
  middle /= static_cast<double>(loop.size());
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = mesh.vertices[loop[i]] - middle;
    const Vec3 b = mesh.vertices[loop[(i + 1) % loop.size()]] - middle;
    area += 0.5 * a.cross(b).norm();
  }
  return area;
}

// Whether the plan has found what all positions together would still show.
bool knowsWhatIsLeft(const Plan* plan) {
  return plan != nullptr && plan->outcome != PlanOutcome::Found && plan->voids &&
         plan->voids->patches.size() == plan->outlook.size();
}

}  // namespace

Completeness completenessOf(const Mesh& mesh, const Plan* plan) {
  const MeshMeasures measures = measure(mesh);
  Completeness result;
  result.pieces = measures.components;
  if (mesh.triangles.empty()) return result;
  const MeshTopology topology(mesh);
  double missing = 0.0;
  for (const std::vector<std::uint32_t>& loop : openings(mesh, topology)) {
    missing += spannedArea(mesh, loop);
    ++result.holes;
  }
  const double scannable = knowsWhatIsLeft(plan) ? plan->voidLeft : missing;
  result.closed = result.holes == 0 && measures.nonManifoldEdges == 0;
  result.wholeCovered = measures.area > 0.0 ? measures.area / (measures.area + missing) : 0.0;
  result.scannableCovered = measures.area > 0.0 ? measures.area / (measures.area + scannable) : 0.0;
  return result;
}

}  // namespace vantage
