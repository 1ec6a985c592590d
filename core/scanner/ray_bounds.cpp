#include "scanner/ray_bounds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "scanner/ray_grid.h"

namespace vantage {
namespace {

// Room for rounding [mm].
constexpr double kSlack = 1e-6;
// Where along its rays a side of the grid is looked at [mm].
constexpr double kDepth = 1e3;

// The rays, and the rim half a cell outside of them: every ray of the widened grid is a convex combination of these.
class RaysWithRim {
 public:
  explicit RaysWithRim(const RayGrid& rays) : rays_(rays) {
    const double top = -0.5;
    const double bottom = rays.rows() - 0.5;
    const double left = -0.5;
    const double right = rays.columns() - 0.5;
    for (int r = 0; r < rays.rows(); ++r)
      for (const double c : {left, right}) rim_.push_back(rays.rayAt({static_cast<double>(r), c}));
    for (int c = 0; c < rays.columns(); ++c)
      for (const double r : {top, bottom}) rim_.push_back(rays.rayAt({r, static_cast<double>(c)}));
    for (const double r : {top, bottom})
      for (const double c : {left, right}) rim_.push_back(rays.rayAt({r, c}));
  }

  template <typename Visit>
  void each(const Visit& visit) const {
    for (std::size_t i = 0; i < rays_.size(); ++i) visit(rays_.ray(i));
    for (const RangingRay& ray : rim_) visit(ray);
  }

 private:
  const RayGrid& rays_;
  std::vector<RangingRay> rim_;
};

Vec3 pointOn(const RangingRay& ray) {
  return ray.origin + kDepth * ray.direction;
}

}  // namespace

std::vector<HalfSpace> boundingHalfSpaces(const RayGrid& rays) {
  const RaysWithRim all(rays);
  Vec3 forward = Vec3::Zero();
  all.each([&](const RangingRay& ray) { forward += ray.direction; });
  forward.normalize();
  double leastForward = 1.0;
  all.each([&](const RangingRay& ray) { leastForward = std::min(leastForward, forward.dot(ray.direction)); });
  if (!(leastForward > 0.01)) return {};

  // Leans the normal forward until no ray leaves the half-space, then moves the plane behind every origin.
  auto enclosing = [&](Vec3 normal) {
    double lean = 0.0;
    all.each(
        [&](const RangingRay& ray) { lean = std::max(lean, -normal.dot(ray.direction) / forward.dot(ray.direction)); });
    normal += (lean > 0.0 ? lean + 1e-12 : 0.0) * forward;
    double offset = std::numeric_limits<double>::infinity();
    all.each([&](const RangingRay& ray) { offset = std::min(offset, normal.dot(ray.origin)); });
    return HalfSpace{normal, offset - kSlack};
  };

  std::vector<HalfSpace> bounds{enclosing(forward)};
  const double lastRow = rays.rows() - 0.5;
  const double lastColumn = rays.columns() - 0.5;
  const Vec3 inside = pointOn(rays.rayAt({0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)}));
  const std::array<std::pair<GridPosition, GridPosition>, 4> sides{{{{-0.5, -0.5}, {lastRow, -0.5}},
                                                                    {{-0.5, lastColumn}, {lastRow, lastColumn}},
                                                                    {{-0.5, -0.5}, {-0.5, lastColumn}},
                                                                    {{lastRow, -0.5}, {lastRow, lastColumn}}}};
  for (const auto& [begin, end] : sides) {
    const RangingRay a = rays.rayAt(begin);
    const RangingRay b = rays.rayAt(end);
    Vec3 normal = (a.direction + b.direction).cross(pointOn(b) - pointOn(a));
    if (!(normal.norm() > kSlack)) continue;
    normal.normalize();
    if (normal.dot(inside - pointOn(a)) < 0.0) normal = -normal;
    bounds.push_back(enclosing(normal));
  }
  return bounds;
}

}  // namespace vantage
