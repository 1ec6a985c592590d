#include "integration/model_projection.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace vantage {
VertexProjector::VertexProjector(const GridSurface& surface, const ZipperOptions& options)
    : surface_(surface),
      tolerance_(std::max(options.surfaceTolerance, options.spacingTolerance * surface.mesh().spacing)),
      minNormalCosine_(std::cos(options.normalTolerance)),
      minRayCosine_(std::cos(options.steepest)) {}

ProjectedVertex VertexProjector::project(const Vec3& p, const Vec3& normal, std::optional<GridPosition>& hint) const {
  ProjectedVertex result;
  const auto position = hint ? surface_.rays().locate(p, *hint) : surface_.rays().locate(p);
  if (!position) return result;
  hint = position;
  const auto contact = surface_.at(*position);
  const double height = contact ? heightAbove(*contact, p) : 0.0;
  if (contact && height > tolerance_) {
    result.refuted = true;
    result.quality = static_cast<float>(surface_.quality(*contact));
  }
  if (-normal.dot(surface_.rays().rayAt(*position).direction) < minRayCosine_) return result;
  result.place = surface_.planePoint(*position);
  result.contact = Contact::Apart;
  if (!contact) {
    if (nearSurface(p, normal, *position)) result.contact = Contact::Near;
  } else if (std::abs(height) <= tolerance_ && normal.dot(surface_.normal(*contact)) >= minNormalCosine_) {
    result.contact = Contact::On;
    result.confidence = static_cast<float>(surface_.confidence(*contact));
    result.quality = static_cast<float>(surface_.quality(*contact));
  }
  return result;
}

// Signed distance from the plane of the view's triangle, positive towards the scanner.
double VertexProjector::heightAbove(const GridContact& contact, const Vec3& p) const {
  const Mesh& mesh = surface_.mesh().mesh;
  const Triangle& t = mesh.triangles[contact.triangle];
  return (p - mesh.vertices[t[0]]).dot(triangleNormal(mesh, t));
}

bool VertexProjector::nearSurface(const Vec3& p, const Vec3& normal, const GridPosition& position) const {
  const RayGrid& rays = surface_.rays();
  const ViewMesh& view = surface_.mesh();
  const int row = static_cast<int>(std::lround(position.row));
  const int column = static_cast<int>(std::lround(position.column));
  double nearest = (kNearCells + 0.5) * (kNearCells + 0.5);
  std::uint32_t found = kNoIndex;
  for (int r = std::max(row - kNearCells, 0); r <= std::min(row + kNearCells, rays.rows() - 1); ++r) {
    for (int c = std::max(column - kNearCells, 0); c <= std::min(column + kNearCells, rays.columns() - 1); ++c) {
      const std::uint32_t v = view.vertexOfSample[rays.index(r, c)];
      const double distance = (r - position.row) * (r - position.row) + (c - position.column) * (c - position.column);
      if (v == kNoIndex || distance >= nearest || normal.dot(view.normals[v]) < minNormalCosine_ ||
          std::abs((p - view.mesh.vertices[v]).dot(view.normals[v])) > tolerance_)
        continue;
      nearest = distance;
      found = v;
    }
  }
  return found != kNoIndex;
}

std::vector<ProjectedVertex> projectModel(const Model& model, const GridSurface& surface, const ZipperOptions& options,
                                          const Progress& progress) {
  const std::vector<Vec3> normals = computeVertexNormals(model.mesh);
  const Pose& T_scanner_object = surface.T_scanner_object();
  const VertexProjector projector(surface, options);
  std::vector<ProjectedVertex> result(model.mesh.vertices.size());
  parallelChunks(result.size(), 2048, progress, [&](std::size_t begin, std::size_t end) {
    std::optional<GridPosition> hint;
    for (std::size_t v = begin; v < end; ++v)
      result[v] =
          projector.project(T_scanner_object * model.mesh.vertices[v], T_scanner_object.linear() * normals[v], hint);
  });
  return result;
}

}  // namespace vantage
