#include "finishing/loose_pieces.h"

#include <algorithm>

#include "geometry/mesh_topology.h"

namespace vantage {

std::vector<SurfacePiece> piecesOf(const Mesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<std::uint8_t> seen(mesh.triangles.size(), 0);
  std::vector<SurfacePiece> pieces;
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (seen[first] != 0) continue;
    SurfacePiece piece{{first}, 0.0};
    seen[first] = 1;
    for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t other = topology.neighbour(piece.triangles[i], k);
        if (other == kNoIndex || seen[other] != 0) continue;
        seen[other] = 1;
        piece.triangles.push_back(other);
      }
    }
    std::sort(piece.triangles.begin(), piece.triangles.end());
    for (const std::uint32_t t : piece.triangles) piece.area += triangleArea(mesh, mesh.triangles[t]);
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const SurfacePiece& a, const SurfacePiece& b) { return a.area > b.area; });
  return pieces;
}

std::vector<std::uint8_t> loosePieces(const Mesh& mesh, double largestArea) {
  std::vector<std::uint8_t> loose(mesh.triangles.size(), 0);
  const std::vector<SurfacePiece> pieces = piecesOf(mesh);
  for (std::size_t i = 1; i < pieces.size(); ++i)
    if (pieces[i].area <= largestArea)
      for (const std::uint32_t t : pieces[i].triangles) loose[t] = 1;
  return loose;
}

double signedVolume(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
  if (triangles.empty()) return 0.0;
  // About a point of the piece: far from the origin the sum would cancel.
  const Vec3& origin = mesh.vertices[mesh.triangles[triangles.front()][0]];
  double volume = 0.0;
  for (const std::uint32_t t : triangles)
    volume += areaVector(mesh, mesh.triangles[t]).dot(mesh.vertices[mesh.triangles[t][0]] - origin);
  return volume / 6.0;
}

}  // namespace vantage
