#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "finishing/surface_distance.h"
#include "geometry/mesh.h"

namespace vantage {

struct SimplificationOptions {
  std::optional<std::size_t> maxTriangles = {};  ///< as many at most
  std::optional<double> maxError = {};           ///< [mm] the greatest distance measured afterwards is no larger
};

/// A surface with fewer triangles, and how far it lies from the one that it stands for.
struct SimplifiedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> vertexOf;  ///< per vertex: the one of the input that it is
  SurfaceDistance error;                ///< measured both ways
  bool reached = true;                  ///< whether there are no more triangles than asked for
};

/// Fewer triangles by edge collapses (see decimate): as few as the greatest error allows, or no more than a number.
/// Borders stay as they are. With a greatest error the result is measured, and coarsened less until it keeps it.
/// @throws InvalidInput when neither limit is set, one is 0 or not a number, or the mesh is empty; Cancelled
[[nodiscard]] SimplifiedMesh simplify(const Mesh& mesh, const SimplificationOptions& options,
                                      const Progress& progress = {});

}  // namespace vantage
