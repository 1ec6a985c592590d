#include "calibration/rough_axis.h"

#include <cmath>

namespace vantage {

Vec3 upAlongColumns(const RayGrid& rays, const Vec3& point) {
  const auto at = [&](double row) {
    const RangingRay ray = rays.rayAt({row * (rays.rows() - 1), 0.5 * (rays.columns() - 1)});
    return Vec3(ray.origin + (point - ray.origin).norm() * ray.direction);
  };
  return (at(0.0) - at(1.0)).normalized();
}

std::vector<RoughAxis> roughAxes(const std::optional<PlaneFit>& table, const Vec3& centre, const RayGrid& rays,
                                 double extent) {
  const Vec3 up = table ? table->normal : Vec3::UnitZ();
  const Vec3 sight = (centre - rays.rayAt({0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)}).origin).normalized();
  std::vector<RoughAxis> axes{{Vec3::Zero(), up}};
  for (const double behind : {0.2, 0.0, 0.4}) axes.push_back({centre + behind * extent * sight, up});
  if (table) return axes;
  // The frame of the scanner may lie anyhow.
  const Vec3 columns = upAlongColumns(rays, centre);
  if (std::abs(columns.dot(up)) < std::cos(kRoughAxisLean)) {
    axes.push_back({centre + 0.2 * extent * sight, columns});
    axes.push_back({centre, columns});
  }
  return axes;
}

}  // namespace vantage
