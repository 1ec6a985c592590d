#include "planning/planning_surface.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "geometry/decimation.h"
#include "geometry/measures.h"
#include "geometry/mesh_topology.h"
#include "geometry/vertex_clustering.h"

namespace vantage {
namespace {

// Collapsing the edges of more triangles than this one after the other takes seconds.
constexpr std::size_t kManyTriangles = 400'000;
// Clusters leave room for the triangles at the border, which stay.
constexpr double kClusteredShare = 0.5;
// A surface that is bent over less than this many errors is collapsed edge by edge [errors].
constexpr double kCubePerError = 8.0;

Mesh collapsed(const Mesh& mesh, std::size_t mostTriangles, double maxError, const Progress& progress) {
  if (mesh.triangles.size() <= mostTriangles) return mesh;
  DecimationOptions decimation;
  decimation.targetTriangles = mostTriangles / 2;
  decimation.maxError = maxError;
  return decimate(mesh, decimation, progress);
}

}  // namespace

Mesh tracedMesh(const Mesh& mesh, std::size_t mostTriangles, double maxError, const Progress& progress) {
  if (mesh.triangles.size() <= std::max(kManyTriangles, mostTriangles))
    return collapsed(mesh, mostTriangles, maxError, progress);
  const auto wanted = static_cast<std::size_t>(kClusteredShare * static_cast<double>(mostTriangles));
  const double cube = std::min(cubeFor(area(mesh), wanted), kCubePerError * maxError);
  if (!(cube > 0.0)) return collapsed(mesh, mostTriangles, maxError, progress);
  return collapsed(clustered(mesh, cube, progress.part(0.0, 0.5)), mostTriangles, maxError, progress.part(0.5, 1.0));
}

Mesh withoutBorder(const Mesh& mesh, int rings) {
  std::vector<std::uint8_t> nearBorder = MeshTopology(mesh).onBoundary();
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::uint8_t> grown = nearBorder;
    for (const Triangle& t : mesh.triangles)
      if (nearBorder[t[0]] || nearBorder[t[1]] || nearBorder[t[2]]) grown[t[0]] = grown[t[1]] = grown[t[2]] = 1;
    nearBorder = std::move(grown);
  }
  Mesh inner = mesh;
  std::erase_if(inner.triangles,
                [&](const Triangle& t) { return nearBorder[t[0]] || nearBorder[t[1]] || nearBorder[t[2]]; });
  return inner;
}

std::vector<SurfaceElement> surfaceElements(const Mesh& mesh, std::size_t count) {
  const std::size_t stride = std::max<std::size_t>(1, mesh.triangles.size() / count);
  std::vector<SurfaceElement> elements;
  for (std::size_t i = stride / 2; i < mesh.triangles.size(); i += stride) {
    const Triangle& t = mesh.triangles[i];
    elements.push_back(
        {triangleCentre(mesh, t), triangleNormal(mesh, t), static_cast<double>(stride) * triangleArea(mesh, t)});
  }
  return elements;
}

}  // namespace vantage
