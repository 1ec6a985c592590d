#include "io/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"

namespace vantage {
namespace {

constexpr double kLeastSamplesAcross = 10.0;

// Three significant digits.
std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

// Median distance of neighbouring rays where they pass the middle of the viewing volume [mm].
double spacingInVolume(const ScannerProfile& profile) {
  const RayGrid& rays = *profile.rays;
  const Vec3 middle(0.0, 0.0, 0.5 * profile.viewingVolume.height);
  const Pose T_scanner_table =
      profile.workspace.size() == 0 ? Pose::Identity() : Pose(profile.workspace.poses.front().inverse());
  const Vec3 target = T_scanner_table * middle;
  const auto nearest = [&](std::size_t i) {
    const RangingRay& ray = rays.ray(i);
    return Vec3(ray.origin + (target - ray.origin).dot(ray.direction) * ray.direction);
  };
  std::vector<double> distances;
  const std::size_t stride = rays.size() / 1000 + 1;
  for (std::size_t i = 0; i + 1 < rays.size(); i += stride)
    if ((i + 1) % static_cast<std::size_t>(rays.columns()) != 0)
      distances.push_back((nearest(i + 1) - nearest(i)).norm());
  if (distances.empty()) return 0.0;
  const auto half = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), half, distances.end());
  return *half;
}

}  // namespace

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

PlacedMesh loadPlacedMesh(const std::string& path, const PlacementOptions& options, const ViewingVolume& volume,
                          const Progress& progress) {
  LoadedMesh loaded = loadMesh(path, {}, progress);
  const double unit = options.unit.value_or(1.0);
  if (unit != 1.0) loaded.mesh = placed(std::move(loaded.mesh), {unit, Vec3::Zero()});
  PlacedMesh object{{}, loaded.repair, computePlacement(loaded.mesh, options.placement, volume)};
  object.mesh = placed(std::move(loaded.mesh), object.transform);
  object.transform.scale *= unit;
  return object;
}

std::vector<PossibleUnit> unitsInDoubt(const Mesh& mesh, const ScannerProfile& profile) {
  const double size = boundingBox(mesh).size().maxCoeff();
  const double spacing = spacingInVolume(profile);
  if (!(size > 0.0) || !(spacing > 0.0) || size >= kLeastSamplesAcross * spacing) return {};
  const double room = std::max(2.0 * profile.viewingVolume.radius, profile.viewingVolume.height);
  std::vector<PossibleUnit> units{{LengthUnit::Millimetre, size, size / spacing}};
  for (const LengthUnit unit : kLengthUnits) {
    const double scaled = size * millimetresIn(unit);
    if (scaled >= kLeastSamplesAcross * spacing && scaled <= room) units.push_back({unit, scaled, scaled / spacing});
  }
  if (units.size() == 1) return {};
  return units;
}

void requireClearUnit(const std::string& path, const PlacementOptions& options, const Mesh& mesh,
                      const ScannerProfile& profile) {
  if (options.unit || options.placement != Placement::AsIs) return;
  const std::vector<PossibleUnit> units = unitsInDoubt(mesh, profile);
  if (units.empty()) return;
  std::string others;
  for (std::size_t i = 1; i < units.size(); ++i)
    others += (i == 1 ? "" : ", ") + std::string(name(units[i].unit)) + " (" + rounded(units[i].size) + " mm)";
  throw InvalidInput(path + ": its unit is not clear: as millimetres it is " + rounded(units.front().size) +
                     " mm in size, across which the scanner takes " + rounded(units.front().samples) +
                     " samples; it could be in " + others + ": say --unit mm, cm, inch or m (setting simulation.unit)");
}

bool isInside(const Mesh& mesh, const ViewingVolume& volume, double slack) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& v) {
    return v.head<2>().norm() <= volume.radius + slack && v.z() >= -slack && v.z() <= volume.height + slack;
  });
}

}  // namespace vantage
