#include "positional_space/ray_fan.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scanner/thinning.h"

namespace vantage {
namespace {

// Rays that leave at more than this slope off the normal run along the surface and meet the volume in another cell.
constexpr double kLeastNormalPart = 0.02;
// Distance of the neighbours that the fan is taken from [grid cells].
constexpr double kHalfStep = 0.5;

// A scanner with more rays than the first is thinned until no more than the second are left.
constexpr std::size_t kManyRays = 1'000'000;
constexpr double kEnoughRays = 250'000.0;

int stepOf(const RayGrid& rays) {
  if (rays.size() <= kManyRays) return 1;
  const double step = std::ceil(std::sqrt(static_cast<double>(rays.size()) / kEnoughRays));
  return std::max(1, std::min({static_cast<int>(step), rays.rows() - 1, rays.columns() - 1}));
}

RayGrid setBack(const RayGrid& rays, double reach) {
  std::vector<RangingRay> moved;
  moved.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    moved.push_back({rays.ray(i).origin - reach * rays.ray(i).direction, rays.ray(i).direction});
  return {rays.rows(), rays.columns(), std::move(moved), {}, 0};
}

// Where a ray crosses the plane of a surface cell, and its slope there.
struct Crossing {
  Vec2 place;
  Vec2 slope;
};

Crossing cross(const SurfaceCell& cell, const RangingRay& ray, const Pose& T_object_scanner) {
  const Vec3 origin = T_object_scanner * ray.origin - cell.centre;
  const Vec3 outward = -(T_object_scanner.linear() * ray.direction);
  const double normalPart = outward.dot(cell.normal);
  const Vec3 p = origin - origin.dot(cell.normal) / normalPart * outward;
  return {Vec2(p.dot(cell.across), p.dot(cell.up)), Vec2(outward.dot(cell.across), outward.dot(cell.up)) / normalPart};
}

}  // namespace

std::shared_ptr<const RayGrid> usefulRays(const std::shared_ptr<const RayGrid>& rays) {
  return thinnedRays(rays, stepOf(*rays));
}

RayFan::RayFan(const std::shared_ptr<const RayGrid>& rays, double reach)
    : whole_(rays), step_(stepOf(*rays)), rays_(setBack(*thinnedRays(rays, step_), reach)), reach_(reach) {}

std::optional<FanRay> RayFan::through(const SurfaceCell& cell, const Pose& T_object_scanner,
                                      std::optional<GridPosition>& hint) const {
  const Vec3 p = T_object_scanner.inverse(Eigen::Isometry) * cell.centre;
  const auto found = hint ? rays_.locate(p, *hint) : rays_.locate(p);
  if (!found) return std::nullopt;
  hint = found;
  const RangingRay ray = rays_.rayAt(*found);
  FanRay fan;
  fan.direction = -(T_object_scanner.linear() * ray.direction);
  if (fan.direction.dot(cell.normal) < kLeastNormalPart) return std::nullopt;
  fan.slope = cross(cell, ray, T_object_scanner).slope;
  fan.sourceDistance = (p - ray.origin).dot(ray.direction) - reach_;
  fan.sample = rayBeforeThinning(*whole_, step_, rays_.nearest(*found));

  auto neighbour = [&](double rows, double columns) {
    return cross(cell, rays_.rayAt({found->row + rows, found->column + columns}), T_object_scanner);
  };
  Eigen::Matrix2d places;
  Eigen::Matrix2d slopes;
  const Crossing columnAfter = neighbour(0.0, kHalfStep);
  const Crossing columnBefore = neighbour(0.0, -kHalfStep);
  const Crossing rowAfter = neighbour(kHalfStep, 0.0);
  const Crossing rowBefore = neighbour(-kHalfStep, 0.0);
  places << columnAfter.place - columnBefore.place, rowAfter.place - rowBefore.place;
  slopes << columnAfter.slope - columnBefore.slope, rowAfter.slope - rowBefore.slope;
  if (!(std::abs(places.determinant()) > 1e-12 * places.squaredNorm())) return std::nullopt;
  fan.fan = slopes * places.inverse();
  return fan;
}

}  // namespace vantage
