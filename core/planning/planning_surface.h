#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// A piece of the model's surface that a view may re-sample.
struct SurfaceElement {
  Vec3 centre;
  Vec3 normal;  ///< unit
  double area;  ///< [mm^2]
};

/// The mesh that stands for the model in tracing: the model's own until it has so many triangles that decimating it
/// pays, then one of half as many. One of more than 400,000 triangles is clustered first, or only, which takes a time
/// that grows with its size and no more.
/// @param maxError of decimation [mm]; clusters are up to eight times as wide
[[nodiscard]] Mesh tracedMesh(const Mesh& mesh, std::size_t mostTriangles, double maxError, const Progress& progress);

/// The mesh without the triangles along its border: registration leaves them out, so they do not count as overlap.
/// @param rings of vertices next to the border whose triangles are left out too
[[nodiscard]] Mesh withoutBorder(const Mesh& mesh, int rings);

/// An even choice of about `count` of the mesh's triangles, each standing for those it leaves out.
[[nodiscard]] std::vector<SurfaceElement> surfaceElements(const Mesh& mesh, std::size_t count);

}  // namespace vantage
