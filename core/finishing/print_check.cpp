#include "finishing/print_check.h"

#include <algorithm>
#include <numeric>

#include "finishing/border_loops.h"
#include "finishing/loose_pieces.h"
#include "finishing/self_crossings.h"
#include "geometry/mesh_orientation.h"
#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

bool isSurface(const Mesh& mesh, const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && mesh.vertices[t[0]] != mesh.vertices[t[1]] &&
         mesh.vertices[t[1]] != mesh.vertices[t[2]] && mesh.vertices[t[2]] != mesh.vertices[t[0]];
}

std::vector<PrintFault> faultsOf(const Mesh& mesh, const PrintCheck& check) {
  std::vector<PrintFault> faults;
  const auto add = [&](bool wrong, PrintFault fault) {
    if (wrong) faults.push_back(fault);
  };
  add(mesh.triangles.empty(), PrintFault::Empty);
  add(check.openings > 0, PrintFault::Open);
  add(check.nonManifoldEdges > 0, PrintFault::NonManifold);
  add(check.bowTies > 0, PrintFault::BowTies);
  add(check.inwardPieces > 0, PrintFault::Inward);
  add(check.crossings > 0, PrintFault::Crossings);
  add(check.pieces > 1, PrintFault::Pieces);
  return faults;
}

}  // namespace

std::string_view name(PrintFault fault) {
  switch (fault) {
    case PrintFault::Empty:
      return "empty";
    case PrintFault::Open:
      return "open";
    case PrintFault::NonManifold:
      return "non_manifold";
    case PrintFault::BowTies:
      return "bow_ties";
    case PrintFault::Inward:
      return "inward";
    case PrintFault::Crossings:
      return "crossings";
    case PrintFault::Pieces:
      break;
  }
  return "pieces";
}

PrintCheck checkForPrint(const Mesh& mesh, const Progress& progress) {
  progress.checkpoint(0.0);
  PrintCheck check;
  const MeshTopology topology(mesh);
  check.nonManifoldEdges = topology.nonManifoldEdges();
  check.bowTies = countBowTies(mesh);
  if (check.nonManifoldEdges == 0) {
    const std::vector<BorderLoop> loops = borderLoops(mesh);
    check.openings = loops.size();
    for (const BorderLoop& loop : loops) check.widestOpening = std::max(check.widestOpening, loop.width);
  } else {
    check.openings = topology.boundaryEdges().empty() ? 0 : 1;  // where they end cannot be told
  }
  progress.checkpoint(0.3);
  const std::vector<SurfacePiece> pieces = piecesOf(mesh);
  check.pieces = pieces.size();
  if (topology.boundaryEdges().empty() && check.nonManifoldEdges == 0 && !mesh.triangles.empty()) {
    double volume = 0.0;
    for (const SurfacePiece& piece : pieces) {
      const double own = signedVolume(mesh, piece.triangles);
      if (own < 0.0) ++check.inwardPieces;
      volume += own;
    }
    check.volume = volume;
  }
  check.crossings = countCrossings(mesh, progress.part(0.4, 1.0));
  check.faults = faultsOf(mesh, check);
  return check;
}

RepairedSurface repairForPrint(const Mesh& mesh, const Progress& progress) {
  progress.checkpoint(0.0);
  validate(mesh);
  RepairedSurface result;
  result.mesh.vertices = mesh.vertices;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!isSurface(mesh, mesh.triangles[t])) continue;
    result.mesh.triangles.push_back(mesh.triangles[t]);
    result.triangleOf.push_back(t);
  }
  result.dropped = mesh.triangles.size() - result.mesh.triangles.size();
  result.turned = orientOutward(result.mesh).flippedTriangles;
  progress.checkpoint(0.5);
  result.vertexOf.resize(mesh.vertices.size());
  std::iota(result.vertexOf.begin(), result.vertexOf.end(), 0U);
  const std::vector<std::uint32_t> added = splitBowTies(result.mesh);
  result.split = added.size();
  result.vertexOf.insert(result.vertexOf.end(), added.begin(), added.end());
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
