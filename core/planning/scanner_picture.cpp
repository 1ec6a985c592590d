#include "planning/scanner_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/parallel.h"
#include "geometry/ray_caster.h"

namespace vantage {
namespace {

// A patch seen from behind is no void: the ray comes from inside of what it bounds.
constexpr double kEdgeOn = 0.02;
constexpr std::size_t kRaysPerChunk = 512;

// Void patches as a mesh: triangles 2 p and 2 p + 1 are patch p.
Mesh patchMesh(std::span<const VoidPatch> patches) {
  std::vector<std::array<Vec3, 4>> quads;
  quads.reserve(patches.size());
  for (const VoidPatch& patch : patches) quads.push_back(patch.corners);
  return quadMesh(quads);
}

class PictureMaker {
 public:
  PictureMaker(const PlanningScene& scene, const Pose& T_table_scanner)
      : scene_(scene), T_table_scanner_(T_table_scanner), voids_(patchMesh(scene.patches())) {}

  void follow(std::size_t i, ScannerPicture& picture) const {
    const ScannerProfile& profile = scene_.profile();
    const RangingRay& ray = profile.rays->ray(i);
    const Vec3 origin = T_table_scanner_ * ray.origin;
    const Vec3 direction = T_table_scanner_.linear() * ray.direction;
    const auto surface = scene_.obstacles().intersect(origin, direction, profile.minRange, profile.maxRange);
    const double reach = surface ? surface->distance - scene_.sight().options().offset : profile.maxRange;
    const auto patch = voids_.intersect(origin, direction, profile.minRange, std::max(profile.minRange, reach));
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
    if (cosine < std::cos(scene_.breakdownAngle())) return RaySight::TooSteep;
    const bool seen = scene_.sight().received(T_table_scanner_, i, origin + hit.distance * direction, hit.normal);
    return seen ? RaySight::Surface : RaySight::ReceiverBlocked;
  }

  const PlanningScene& scene_;
  const Pose& T_table_scanner_;
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

std::size_t ScannerPicture::count(RaySight wanted) const {
  return static_cast<std::size_t>(std::count(sight.begin(), sight.end(), wanted));
}

ScannerPicture computeScannerPicture(const PlanningScene& scene, int position, const Progress& progress) {
  const PictureMaker maker(scene, scene.pose(position));
  const RayGrid& rays = *scene.profile().rays;
  ScannerPicture picture;
  picture.rows = rays.rows();
  picture.columns = rays.columns();
  picture.sight.assign(rays.size(), RaySight::Nothing);
  picture.cosine.assign(rays.size(), 0.0F);
  picture.range.assign(rays.size(), 0.0F);
  orient(rays, picture);
  parallelChunks(rays.size(), kRaysPerChunk, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) maker.follow(i, picture);
  });
  return picture;
}

}  // namespace vantage
