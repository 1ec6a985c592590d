#pragma once

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// How far two surfaces are apart, measured from the vertices and the centres of the triangles of either to the nearest
/// point of the other.
struct SurfaceDistance {
  double greatest = 0.0;  ///< of both ways [mm]
  double rms = 0.0;       ///< root mean square of both ways, every triangle weighted by its area [mm]
};

/// @throws InvalidInput when one of them has no surface; Cancelled
[[nodiscard]] SurfaceDistance distanceBetween(const Mesh& a, const Mesh& b, const Progress& progress = {});

}  // namespace vantage
