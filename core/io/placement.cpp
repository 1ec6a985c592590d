#include "io/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"

namespace vantage {

Placement parsePlacement(std::string_view text) {
  if (text == "as-is") return Placement::AsIs;
  if (text == "fit") return Placement::Fit;
  throw InvalidInput("placement is '" + std::string(text) + "', expected as-is or fit");
}

std::string name(Placement placement) {
  return placement == Placement::Fit ? "fit" : "as-is";
}

PlacementTransform computePlacement(const Mesh& mesh, Placement placement, const ViewingVolume& volume) {
  if (placement == Placement::AsIs) return {};
  const BoundingBox box = boundingBox(mesh);
  const Vec3 foot(box.centre().x(), box.centre().y(), box.min.z());
  double radius = 0.0;
  for (const Vec3& v : mesh.vertices) radius = std::max(radius, (v - foot).head<2>().norm());
  const double height = box.size().z();
  if (!(std::max(radius, height) > 0.0))
    throw InvalidInput("a mesh without extent cannot be fitted into the viewing volume");
  constexpr double kFree = std::numeric_limits<double>::infinity();
  PlacementTransform transform;
  transform.scale = kFittedShare * std::min(radius > 0.0 ? volume.radius / radius : kFree,
                                            height > 0.0 ? volume.height / height : kFree);
  transform.translation = -transform.scale * foot;
  return transform;
}

Mesh placed(Mesh mesh, const PlacementTransform& transform) {
  for (Vec3& v : mesh.vertices) v = transform.scale * v + transform.translation;
  return mesh;
}

PlacedMesh loadPlacedMesh(const std::string& path, Placement placement, const ViewingVolume& volume,
                          const Progress& progress) {
  LoadedMesh loaded = loadMesh(path, {}, progress);
  PlacedMesh object{{}, loaded.repair, computePlacement(loaded.mesh, placement, volume)};
  object.mesh = placed(std::move(loaded.mesh), object.transform);
  return object;
}

bool isInside(const Mesh& mesh, const ViewingVolume& volume, double slack) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& v) {
    return v.head<2>().norm() <= volume.radius + slack && v.z() >= -slack && v.z() <= volume.height + slack;
  });
}

}  // namespace vantage
