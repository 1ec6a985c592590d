#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

struct DecimationOptions {
  std::size_t targetTriangles = 30000;
  /// [mm] How far a vertex may lie from the planes it stands for (root mean square over their area). Decimation stops
  /// short of the target rather than go beyond.
  double maxError = 0.5;
  bool keepBoundary = true;  ///< boundary edges survive as they are; without it the boundary may recede
};

/// A coarser mesh by quadric edge collapse onto one of the edge's ends: its vertices are some of the input's.
/// Orientation and manifoldness are kept; no triangle turns by more than 60 degrees in one collapse. Degenerate and
/// non-manifold triangles of the input are dropped, unless it is small enough already: then it is returned as it is.
/// Deterministic.
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have; Cancelled.
[[nodiscard]] Mesh decimate(const Mesh& mesh, const DecimationOptions& options, const Progress& progress = {});

/// A mesh with the vertices of another that it has.
struct DecimatedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> vertexOf;  ///< per vertex: the one of the input that it is
};
/// The same, and where its vertices came from.
[[nodiscard]] DecimatedMesh decimateKnowing(const Mesh& mesh, const DecimationOptions& options,
                                            const Progress& progress = {});

}  // namespace vantage
