#pragma once

#include <cstddef>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

struct DecimationOptions {
  std::size_t targetTriangles = 30000;
  double maxError = 0.5;      ///< [mm] quadric distance at which decimation stops short of the target
  bool keepBoundary = true;   ///< boundary edges survive as they are
};

/// A coarser mesh by quadric edge collapse. Orientation and manifoldness are kept. Non-manifold triangles of the input
/// are dropped. Deterministic.
/// @throws Cancelled
[[nodiscard]] Mesh decimate(const Mesh& mesh, const DecimationOptions& options, const Progress& progress = {});

}  // namespace vantage
