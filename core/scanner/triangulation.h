#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "scanner/range_image.h"

namespace vantage {

struct TriangulationOptions {
  /// [rad] A triangle whose normal leans farther from its rays than this is no surface.
  double breakdownAngle = radians(60.0);
  /// How much farther than the breakdown angle noise may tilt a single triangle [rad]; unset: 8 degrees.
  std::optional<double> angleSlack;
  /// An edge is a depth discontinuity when it is longer than this many times the spacing of its rays divided by the
  /// cosine of the breakdown angle: steep but continuous surface survives, a jump does not.
  double discontinuityFactor = 1.4;
};

/// A range image as a mesh, in scanner coordinates, and what every vertex came from.
struct ViewMesh {
  Mesh mesh;
  std::vector<std::uint32_t> sample;          ///< per vertex: index into the ray grid
  std::vector<std::uint32_t> vertexOfSample;  ///< per ray: vertex, or kNoIndex where no triangle uses the sample
  std::vector<Vec3> normals;                  ///< per vertex, unit, toward the scanner
  std::vector<float> confidence;              ///< per vertex: cos of the angle between normal and ray, in (0, 1]
  std::vector<std::uint8_t> onBoundary;       ///< per vertex: 1 on the mesh's boundary
  double spacing = 0.0;                       ///< median distance between neighbouring samples across the ray [mm]
};

/// Turns grid neighbours into triangles unless an edge is a depth discontinuity or the triangle is too steep.
/// No edge has more than two triangles; all are oriented toward the scanner.
/// @throws InvalidInput for a range image that is not one; Cancelled
[[nodiscard]] ViewMesh triangulate(const RangeImage& image, const TriangulationOptions& options,
                                   const Progress& progress = {});

}  // namespace vantage
