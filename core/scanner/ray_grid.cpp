#include "scanner/ray_grid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

// Rays are followed this far outside of the grid before p counts as missed [cells].
constexpr double kMargin = 0.5;
// The search stops when a step is shorter than this [cells].
constexpr double kConverged = 1e-4;
constexpr int kMaxSteps = 20;
// Starts along each side of the grid when nothing is known.
constexpr int kStarts = 5;

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

// Gauss-Newton on the two grid coordinates; the residual is the offset of p from the interpolated ray.
std::optional<GridPosition> RayGrid::descend(const Vec3& p, GridPosition position) const {
  for (int step = 0; step < kMaxSteps; ++step) {
    const RangingRay ray = rayAt(position);
    const Vec3 residual = offsetFrom(ray, p);
    const int r = std::clamp(static_cast<int>(std::floor(position.row)), 0, rows_ - 2);
    const int c = std::clamp(static_cast<int>(std::floor(position.column)), 0, columns_ - 2);
    // How the ray moves at p per cell, perpendicular to it.
    const double depth = (p - ray.origin).dot(ray.direction);
    auto motion = [&](const RangingRay& from, const RangingRay& to) {
      const Vec3 m = (to.origin - from.origin) + depth * (to.direction - from.direction);
      return Vec3(m - m.dot(ray.direction) * ray.direction);
    };
    const Vec3 alongColumn = motion(rays_[index(r, c)], rays_[index(r, c + 1)]);
    const Vec3 alongRow = motion(rays_[index(r, c)], rays_[index(r + 1, c)]);
    const double a = alongColumn.squaredNorm();
    const double b = alongColumn.dot(alongRow);
    const double d = alongRow.squaredNorm();
    const double determinant = a * d - b * b;
    if (!(determinant > 1e-12 * a * d) || a * d == 0.0) return std::nullopt;
    const double x = alongColumn.dot(residual);
    const double y = alongRow.dot(residual);
    const double stepColumn = std::clamp((d * x - b * y) / determinant, -columns_ * 0.5, columns_ * 0.5);
    const double stepRow = std::clamp((a * y - b * x) / determinant, -rows_ * 0.5, rows_ * 0.5);
    const double column = position.column + stepColumn;
    const double row = position.row + stepRow;
    // Far outside the linear model means nothing any more; stay near the rim and let the next step decide.
    const GridPosition next{std::clamp(row, -2.0, rows_ + 1.0), std::clamp(column, -2.0, columns_ + 1.0)};
    const double moved = std::max(std::abs(next.row - position.row), std::abs(next.column - position.column));
    position = next;
    if (moved > kConverged) continue;
    if (position.row < -kMargin || position.row > rows_ - 1 + kMargin || position.column < -kMargin ||
        position.column > columns_ - 1 + kMargin)
      return std::nullopt;
    const RangingRay found = rayAt(position);
    if ((p - found.origin).dot(found.direction) <= 0.0) return std::nullopt;
    const double cell = std::sqrt(std::max(a, d));
    if (offsetFrom(found, p).norm() > 0.1 * cell) return std::nullopt;
    return position;
  }
  return std::nullopt;
}

std::optional<GridPosition> RayGrid::locate(const Vec3& p) const {
  const GridPosition centre{0.5 * (rows_ - 1), 0.5 * (columns_ - 1)};
  if (const auto found = descend(p, centre)) return found;
  // An irregular table: begin at the nearest of a coarse set of rays.
  GridPosition best = centre;
  double bestDistance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kStarts; ++i) {
    for (int j = 0; j < kStarts; ++j) {
      const GridPosition start{(rows_ - 1) * (i + 0.5) / kStarts, (columns_ - 1) * (j + 0.5) / kStarts};
      const RangingRay ray = rayAt(start);
      const double distance = offsetFrom(ray, p).norm();
      if ((p - ray.origin).dot(ray.direction) <= 0.0 || distance >= bestDistance) continue;
      best = start;
      bestDistance = distance;
    }
  }
  return descend(p, best);
}

std::optional<GridPosition> RayGrid::locate(const Vec3& p, const GridPosition& hint) const {
  if (const auto found = descend(p, hint)) return found;
  return locate(p);
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
