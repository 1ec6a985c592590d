#include "report/completeness.h"

#include <vector>

#include "acquisition/erased_regions.h"
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

// 1 for the vertices from which an edge leads along which no position shows more.
std::vector<std::uint8_t> outOfSight(const Mesh& mesh, const Plan* plan) {
  std::vector<std::uint8_t> hidden(mesh.vertices.size(), 0);
  if (plan == nullptr || !plan->voids || plan->voids->patches.size() != plan->outlook.size()) return hidden;
  for (std::size_t p = 0; p < plan->outlook.size(); ++p) {
    const std::uint32_t from = plan->voids->patches[p].from;
    if (from < hidden.size() && plan->outlook[p].reason != EdgeReason::BelowThreshold) hidden[from] = 1;
  }
  return hidden;
}

}  // namespace

Completeness completenessOf(const Mesh& mesh, const Plan* plan, std::span<const std::uint8_t> erasedBorder) {
  const MeshMeasures measures = measure(mesh);
  Completeness result;
  result.pieces = measures.components;
  if (mesh.triangles.empty()) return result;
  const MeshTopology topology(mesh);
  const std::vector<std::uint8_t> hidden = outOfSight(mesh, plan);
  double missing = 0.0;
  double scannable = 0.0;
  for (const std::vector<std::uint32_t>& loop : openings(mesh, topology)) {
    std::size_t out = 0;
    std::size_t erased = 0;
    for (const std::uint32_t v : loop) {
      out += hidden[v];
      erased += v < erasedBorder.size() && erasedBorder[v] != 0 ? 1 : 0;
    }
    const double erasedShare = static_cast<double>(erased) / static_cast<double>(loop.size());
    const double area = spannedArea(mesh, loop) * (1.0 - erasedShare);
    result.erasedHoles += erasedShare > 0.5 ? 1 : 0;
    missing += area;
    scannable += area * (1.0 - static_cast<double>(out) / static_cast<double>(loop.size()));
    ++result.holes;
  }
  result.closed = result.holes == 0 && measures.nonManifoldEdges == 0;
  result.wholeCovered = measures.area > 0.0 ? measures.area / (measures.area + missing) : 0.0;
  // A forecast tells it itself.
  if (plan != nullptr && plan->forecast && plan->forecast->left) scannable = plan->forecast->left->area;
  result.scannableCovered = measures.area > 0.0 ? measures.area / (measures.area + scannable) : 0.0;
  return result;
}

Completeness completenessOf(const AcquisitionState& state) {
  if (!state.model) return completenessOf(Mesh{}, nullptr);
  return completenessOf(state.model->mesh, state.plan.get(), erasedBorderNow(state));
}

}  // namespace vantage
