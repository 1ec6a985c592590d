#include "planning/scanner_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/ray_caster.h"

namespace vantage {
namespace {

// A patch seen from behind is no void: the ray comes from inside of what it bounds.
constexpr double kEdgeOn = 0.02;
constexpr std::size_t kRaysPerChunk = 512;
// Lines to the receivers begin this far in front of the surface [mm].
constexpr double kSurfaceOffset = 0.3;

class Looker {
 public:
  Looker(const ScannerProfile& profile, int position, const Model& model, const VoidSurface* voids)
      : profile_(profile),
        pose_(profile.workspace.poses[static_cast<std::size_t>(position)]),
        surface_(model.mesh),
        voids_(voids != nullptr ? patchMesh(*voids) : Mesh{}) {}

  void look(std::size_t i, ScannerPicture& picture) const {
    const RangingRay& ray = profile_.rays->ray(i);
    const Vec3 origin = pose_ * ray.origin;
    const Vec3 direction = pose_.linear() * ray.direction;
    const auto surface = surface_.intersect(origin, direction, profile_.minRange, profile_.maxRange);
    const double reach = surface ? surface->distance - kSurfaceOffset : profile_.maxRange;
    const auto patch = voids_.intersect(origin, direction, profile_.minRange, std::max(profile_.minRange, reach));
    if (patch && -patch->normal.dot(direction) > kEdgeOn)
      enter(picture, i, RaySight::Void, *patch, direction);
    else if (surface)
      enter(picture, i, judge(i, *surface, origin, direction), *surface, direction);
  }

 private:
  static void enter(ScannerPicture& picture, std::size_t i, RaySight sight, const RayHit& hit, const Vec3& direction) {
    picture.sight[i] = sight;
    picture.cosine[i] = static_cast<float>(std::abs(hit.normal.dot(direction)));
    picture.range[i] = static_cast<float>(hit.distance);
  }

  [[nodiscard]] RaySight judge(std::size_t i, const RayHit& hit, const Vec3& origin, const Vec3& direction) const {
    const double cosine = -hit.normal.dot(direction);
    if (cosine <= 0.0) return RaySight::Back;
    if (cosine < std::cos(profile_.breakdownAngle)) return RaySight::TooSteep;
    if (!profile_.rays->triangulates()) return RaySight::Surface;
    const Vec3 point = origin + hit.distance * direction + kSurfaceOffset * hit.normal;
    const auto receivers = profile_.rays->receivers(i);
    const bool seen = std::any_of(receivers.begin(), receivers.end(), [&](const Vec3& receiver) {
      return !surface_.occluded(point, pose_ * receiver, kSurfaceOffset);
    });
    return seen ? RaySight::Surface : RaySight::ReceiverBlocked;
  }

  const ScannerProfile& profile_;
  const Pose& pose_;
  RayCaster surface_;
  RayCaster voids_;
};

// Which way the picture lies, for one who stands at the scanner, looks along its rays and has z upward.
void orient(const RayGrid& rays, ScannerPicture& picture) {
  const auto at = [&](double row, double column) {
    const RangingRay ray =
        rays.rayAt({row * static_cast<double>(rays.rows() - 1), column * static_cast<double>(rays.columns() - 1)});
    return Vec3(ray.origin + std::max(1.0, ray.origin.norm()) * ray.direction);
  };
  const Vec3 forward = rays.rayAt({0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)}).direction;
  const Vec3 right = forward.cross(Vec3::UnitZ());
  picture.rowsUp = (at(1.0, 0.5) - at(0.0, 0.5)).z() > 0.0;
  picture.columnsLeft = (at(0.5, 1.0) - at(0.5, 0.0)).dot(right) < 0.0;
}

}  // namespace

Mesh patchMesh(const VoidSurface& voids) {
  std::vector<std::array<Vec3, 4>> quads;
  quads.reserve(voids.patches.size());
  for (const VoidPatch& patch : voids.patches) quads.push_back(patch.corners);
  return quadMesh(quads);
}

std::size_t ScannerPicture::count(RaySight wanted) const {
  return static_cast<std::size_t>(std::count(sight.begin(), sight.end(), wanted));
}

ScannerPicture computeScannerPicture(const ScannerProfile& profile, int position, const Model& model,
                                     const VoidSurface* voids, const Progress& progress) {
  if (position < 0 || position >= static_cast<int>(profile.workspace.size()))
    throw InvalidInput("position " + std::to_string(position) + " is not in the workspace, which has positions 0 to " +
                       std::to_string(static_cast<int>(profile.workspace.size()) - 1));
  ScannerPicture picture;
  picture.rows = profile.rays->rows();
  picture.columns = profile.rays->columns();
  const std::size_t count = profile.rays->size();
  picture.sight.assign(count, RaySight::Nothing);
  picture.cosine.assign(count, 0.0F);
  picture.range.assign(count, 0.0F);
  orient(*profile.rays, picture);
  const Looker looker(profile, position, model, voids);
  parallelChunks(count, kRaysPerChunk, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) looker.look(i, picture);
  });
  return picture;
}

}  // namespace vantage
