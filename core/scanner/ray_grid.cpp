#include "scanner/ray_grid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

// Perpendicular offset from the ray's line to p.
Vec3 offsetFrom(const RangingRay& ray, const Vec3& p) {
  const Vec3 d = p - ray.origin;
  return d - d.dot(ray.direction) * ray.direction;
}

}  // namespace

RayGrid::RayGrid(int rows, int columns, std::vector<RangingRay> rays, std::vector<Vec3> receivers, int receiversPerRay)
    : rows_(rows),
      columns_(columns),
      receiversPerRay_(receiversPerRay),
      rays_(std::move(rays)),
      receivers_(std::move(receivers)) {
  if (rows < 2 || columns < 2)
    throw InvalidInput("a grid of " + std::to_string(rows) + " x " + std::to_string(columns) +
                       " ranging rays is too small: at least 2 x 2 are needed");
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  if (rays_.size() != count)
    throw InvalidInput(std::to_string(rays_.size()) + " ranging rays given for a grid of " + std::to_string(count));
  if (receiversPerRay < 0 || receivers_.size() != count * static_cast<std::size_t>(receiversPerRay))
    throw InvalidInput(std::to_string(receivers_.size()) + " receivers given for " + std::to_string(count) + " rays");
  for (std::size_t i = 0; i < rays_.size(); ++i)
    if (!rays_[i].origin.allFinite() || !rays_[i].direction.allFinite() ||
        std::abs(rays_[i].direction.norm() - 1.0) > 1e-6)
      throw InvalidInput("ranging ray " + std::to_string(i) + " has no finite origin and unit direction");
  for (const Vec3& r : receivers_)
    if (!r.allFinite()) throw InvalidInput("a receiver position is not finite");
  bounds_ = boundingHalfSpaces(*this);
}

RangingRay RayGrid::rayAt(const GridPosition& position) const {
  const int r = std::clamp(static_cast<int>(std::floor(position.row)), 0, rows_ - 2);
  const int c = std::clamp(static_cast<int>(std::floor(position.column)), 0, columns_ - 2);
  const double v = position.row - r;
  const double u = position.column - c;
  const RangingRay& a = rays_[index(r, c)];
  const RangingRay& b = rays_[index(r, c + 1)];
  const RangingRay& d = rays_[index(r + 1, c)];
  const RangingRay& e = rays_[index(r + 1, c + 1)];
  const double wa = (1 - u) * (1 - v);
  const double wb = u * (1 - v);
  const double wd = (1 - u) * v;
  const double we = u * v;
  return {wa * a.origin + wb * b.origin + wd * d.origin + we * e.origin,
          (wa * a.direction + wb * b.direction + wd * d.direction + we * e.direction).normalized()};
}

std::size_t RayGrid::nearest(const GridPosition& position) const {
  const int r = std::clamp(static_cast<int>(std::lround(position.row)), 0, rows_ - 1);
  const int c = std::clamp(static_cast<int>(std::lround(position.column)), 0, columns_ - 1);
  return index(r, c);
}

double RayGrid::spacingAt(const Vec3& p, const GridPosition& position) const {
  const std::size_t i = nearest(position);
  const int r = static_cast<int>(i) / columns_;
  const int c = static_cast<int>(i) % columns_;
  const double depth = (p - rays_[i].origin).dot(rays_[i].direction);
  const Vec3 here = rays_[i].origin + depth * rays_[i].direction;
  double spacing = 0.0;
  auto consider = [&](int row, int column) {
    if (row < 0 || column < 0 || row >= rows_ || column >= columns_) return;
    spacing = std::max(spacing, offsetFrom(rays_[index(row, column)], here).norm());
  };
  consider(r - 1, c);
  consider(r + 1, c);
  consider(r, c - 1);
  consider(r, c + 1);
  return spacing;
}

}  // namespace vantage
