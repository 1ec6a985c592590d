#include "planning/planning_surface.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "geometry/decimation.h"
#include "geometry/measures.h"
#include "geometry/mesh_topology.h"

namespace vantage {
Mesh tracedMesh(const Mesh& mesh, std::size_t mostTriangles, double maxError, const Progress& progress) {
  if (mesh.triangles.size() <= mostTriangles) return mesh;
  DecimationOptions decimation;
  decimation.targetTriangles = mostTriangles / 2;
  decimation.maxError = maxError;
  return decimate(mesh, decimation, progress);
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
