#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {

/// The partial model M: the surface acquired so far, in object coordinates, and where every part of it came from. The
/// mesh is manifold, consistently oriented and has boundaries where nothing was seen.
struct Model {
  Mesh mesh;
  std::vector<float> confidence;            ///< per vertex: best cos(angle to the ray) among its samples, in (0, 1]
  std::vector<std::uint32_t> vertexView;    ///< per vertex: the view whose sample it is
  std::vector<std::uint32_t> vertexSample;  ///< per vertex: index of that sample in the view's ray grid
  std::vector<std::uint32_t> triangleView;  ///< per triangle: the view that added it (the newer one along a seam)
};

}  // namespace vantage
