#pragma once

#include "geometry/mesh.h"

namespace vantage {

struct OrientationResult {
  std::size_t flippedTriangles = 0;
  std::size_t openSeams = 0;  ///< edges whose two triangles cannot agree (Moebius strip, Klein bottle)
};

/// Turns triangles round until neighbours across every edge with two triangles agree. A piece (connected over such
/// edges) that is closed, but for holes whose boundary is short (its square below a tenth of the area), is turned so
/// that its signed volume V = 1/6 sum a . (b x c) is positive. Any other piece keeps the orientation of the larger part
/// of its area (on a tie that of its first triangle).
OrientationResult orientOutward(Mesh& mesh);

}  // namespace vantage
