#include "registration/registration_target.h"

#include <string>
#include <utility>

#include "base/errors.h"
#include "geometry/mesh_border.h"

namespace vantage {
namespace {

constexpr int kSmoothingRounds = 2;

}  // namespace

std::vector<Vec3> smoothedNormals(const Mesh& mesh) {
  std::vector<Vec3> normals = computeVertexNormals(mesh);
  for (int round = 0; round < kSmoothingRounds; ++round) {
    std::vector<Vec3> sum(normals.size(), Vec3::Zero());
    for (const Triangle& t : mesh.triangles) {
      const Vec3 all = normals[t[0]] + normals[t[1]] + normals[t[2]];
      for (const std::uint32_t v : t) sum[v] += all;
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (const double length = sum[v].norm(); length > 0.0) normals[v] = sum[v] / length;
  }
  return normals;
}

std::vector<std::uint32_t> verticesInside(std::span<const Vec3> normals, std::span<const std::uint8_t> onBorder) {
  std::vector<std::uint32_t> inside;
  for (std::uint32_t v = 0; v < normals.size(); ++v)
    // Isolated vertices have no normal.
    if (onBorder[v] == 0 && normals[v].squaredNorm() >= 0.5) inside.push_back(v);
  return inside;
}

OrientedPoints pointsInside(const Mesh& mesh, std::span<const Vec3> normals, std::span<const std::uint8_t> onBorder,
                            std::span<const float> confidence) {
  OrientedPoints inside;
  for (const std::uint32_t v : verticesInside(normals, onBorder)) {
    inside.points.push_back(mesh.vertices[v]);
    inside.normals.push_back(normals[v]);
    inside.confidence.push_back(confidence.empty() ? 1.0F : confidence[v]);
  }
  return inside;
}

RegistrationTarget::RegistrationTarget(const Mesh& model, std::span<const float> confidence) {
  if (!confidence.empty() && confidence.size() != model.vertices.size())
    throw InvalidInput(std::to_string(confidence.size()) + " confidences given for a model of " +
                       std::to_string(model.vertices.size()) + " vertices");
  validate(model);
  surface_ = pointsInside(model, smoothedNormals(model), borderVertices(model), confidence);
}

RegistrationTarget::RegistrationTarget(std::span<const View> views) {
  for (const View& view : views) {
    const ViewMesh& v = *view.mesh;
    surface_.append(pointsInside(v.mesh, smoothedNormals(v.mesh), v.onBoundary, v.confidence), view.T_object_scanner);
  }
}

RegistrationTarget::RegistrationTarget(OrientedPoints points) : surface_(std::move(points)) {}

}  // namespace vantage
