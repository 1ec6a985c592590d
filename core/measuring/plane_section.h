#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "measuring/surface_plane.h"

namespace vantage {

/// A line in which a plane cuts a surface.
struct SectionLine {
  std::vector<Vec3> points;  ///< in order; of a closed one the first is not repeated
  bool closed = false;
  double length = 0.0;  ///< [mm]
};

/// What a plane cuts out of a surface.
struct PlaneSection {
  std::vector<SectionLine> lines;
  double length = 0.0;  ///< of all lines [mm]
  /// [mm^2] inside of the surface, when every line is closed: what lines inside of others go about is taken off.
  std::optional<double> area;
};

/// Cuts a surface by a plane. Lines go counter-clockwise about the material, seen from the front of the plane. A vertex
/// on the plane counts as before it, so that every line goes from edge to edge.
/// @throws InvalidInput when a triangle names a vertex that the mesh does not have; Cancelled
[[nodiscard]] PlaneSection sectionOf(const Mesh& mesh, const SurfacePlane& plane, const Progress& progress = {});

}  // namespace vantage
