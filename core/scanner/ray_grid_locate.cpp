#include <algorithm>
#include <cmath>
#include <limits>

#include "scanner/ray_grid.h"

namespace vantage {
namespace {

// The outermost rays stand for surface up to this far outside of the grid [cells].
constexpr double kMargin = 0.5;
// The search stops when a step is shorter than this [cells].
constexpr double kConverged = 1e-4;
constexpr int kMaxSteps = 16;
// Cells on either side of a place that are asked one by one where the rays are uneven.
constexpr int kReach = 2;
// Starts along each side of the grid when the hint leads nowhere.
constexpr int kStarts = 5;

// The rays between four neighbours, interpolated: o(u, v) + t d(u, v), u across the columns and v across the rows.
class Cell {
 public:
  // The cell that holds a position; outside of the grid the nearest one.
  Cell(const RayGrid& rays, const GridPosition& position)
      : row_(std::clamp(static_cast<int>(std::floor(position.row)), 0, rays.rows() - 2)),
        column_(std::clamp(static_cast<int>(std::floor(position.column)), 0, rays.columns() - 2)),
        a_(rays.ray(rays.index(row_, column_))),
        b_(rays.ray(rays.index(row_, column_ + 1))),
        c_(rays.ray(rays.index(row_ + 1, column_))),
        d_(rays.ray(rays.index(row_ + 1, column_ + 1))) {}

  [[nodiscard]] int row() const { return row_; }
  [[nodiscard]] int column() const { return column_; }

  // Newton's step (du, dv) from the ray at (u, v) toward the one that passes through p; nothing where the rays meet.
  [[nodiscard]] std::optional<Vec2> step(const Vec3& p, double u, double v) const {
    const double a = (1 - u) * (1 - v);
    const double b = u * (1 - v);
    const double c = (1 - u) * v;
    const double d = u * v;
    const Vec3 direction = a * a_.direction + b * b_.direction + c * c_.direction + d * d_.direction;
    const Vec3 offset = p - (a * a_.origin + b * b_.origin + c * c_.origin + d * d_.origin);
    double t = offset.dot(direction) / direction.squaredNorm();
    if (!(t > 0.0)) t = offset.norm();
    // How the point at depth t moves with u and v.
    const Vec3 alongU = (1 - v) * between(a_, b_, t) + v * between(c_, d_, t);
    const Vec3 alongV = (1 - u) * between(a_, c_, t) + u * between(b_, d_, t);
    const Vec3 across = alongV.cross(direction);
    const double determinant = alongU.dot(across);
    if (!(determinant * determinant > 1e-12 * alongU.squaredNorm() * across.squaredNorm())) return std::nullopt;
    const Vec3 residual = offset - t * direction;
    return Vec2(residual.dot(across), residual.dot(direction.cross(alongU))) / determinant;
  }

  // Where in the cell, or beyond its sides, the ray through p lies.
  [[nodiscard]] std::optional<Vec2> solve(const Vec3& p) const {
    Vec2 place(0.5, 0.5);
    for (int i = 0; i < kMaxSteps; ++i) {
      const auto move = step(p, place.x(), place.y());
      if (!move || move->cwiseAbs().maxCoeff() > 10.0) return std::nullopt;
      place += *move;
      if (move->cwiseAbs().maxCoeff() < kConverged) return place;
    }
    return std::nullopt;
  }

 private:
  static Vec3 between(const RangingRay& from, const RangingRay& to, double t) {
    return (to.origin - from.origin) + t * (to.direction - from.direction);
  }

  int row_;
  int column_;
  const RangingRay& a_;
  const RangingRay& b_;
  const RangingRay& c_;
  const RangingRay& d_;
};

// Whether a position is at most half a cell outside of the grid and its ray runs toward p.
bool reaches(const RayGrid& rays, const GridPosition& position, const Vec3& p) {
  if (position.row < -kMargin || position.row > rays.rows() - 1 + kMargin) return false;
  if (position.column < -kMargin || position.column > rays.columns() - 1 + kMargin) return false;
  const RangingRay ray = rays.rayAt(position);
  return (p - ray.origin).dot(ray.direction) > 0.0;
}

// Asks the cells around a place one by one; those at the rim answer for what lies outside of them, too.
std::optional<GridPosition> searchCells(const RayGrid& rays, const Vec3& p, const GridPosition& around) {
  const Cell middle(rays, around);
  const int lastRow = rays.rows() - 2;
  const int lastColumn = rays.columns() - 2;
  for (int r = std::max(middle.row() - kReach, 0); r <= std::min(middle.row() + kReach, lastRow); ++r) {
    for (int c = std::max(middle.column() - kReach, 0); c <= std::min(middle.column() + kReach, lastColumn); ++c) {
      const auto place = Cell(rays, {static_cast<double>(r), static_cast<double>(c)}).solve(p);
      if (!place) continue;
      const double u = place->x();
      const double v = place->y();
      if ((u < -kConverged && c > 0) || (u > 1 + kConverged && c < lastColumn)) continue;
      if ((v < -kConverged && r > 0) || (v > 1 + kConverged && r < lastRow)) continue;
      const GridPosition position{r + v, c + u};
      if (reaches(rays, position, p)) return position;
    }
  }
  return std::nullopt;
}

// Newton's method from cell to cell. Where the rays are uneven it may step back and forth between cells; then those
// around the place are searched.
std::optional<GridPosition> descend(const RayGrid& rays, const Vec3& p, GridPosition position) {
  const double rows = rays.rows();
  const double columns = rays.columns();
  double longest = 0.5;  // step, as a share of the grid
  for (int i = 0; i < kMaxSteps; ++i) {
    const Cell cell(rays, position);
    const auto move = cell.step(p, position.column - cell.column(), position.row - cell.row());
    if (!move) return std::nullopt;
    // A cell knows little of what is far from it: long steps are cut, more and more so that they do not go on for ever,
    // and end near the rim.
    const Vec2 reach(longest * columns, longest * rows);
    const Vec2 cut = move->cwiseMax(-reach).cwiseMin(reach);
    if (cut != *move) longest *= 0.6;
    const double row = std::clamp(position.row + cut.y(), -1.0, rows);
    const double column = std::clamp(position.column + cut.x(), -1.0, columns);
    const double moved = std::max(std::abs(row - position.row), std::abs(column - position.column));
    position = {row, column};
    if (moved > kConverged) continue;
    return reaches(rays, position, p) ? std::optional(position) : std::nullopt;
  }
  return searchCells(rays, p, position);
}

// The ray nearest to p among a few all over the grid.
GridPosition nearestStart(const RayGrid& rays, const Vec3& p) {
  GridPosition best{0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kStarts; ++i) {
    for (int j = 0; j < kStarts; ++j) {
      const GridPosition start{(rays.rows() - 1) * (i + 0.5) / kStarts, (rays.columns() - 1) * (j + 0.5) / kStarts};
      const RangingRay& ray = rays.ray(rays.nearest(start));
      const Vec3 offset = p - ray.origin;
      const double depth = offset.dot(ray.direction);
      const double distance = (offset - depth * ray.direction).squaredNorm();
      if (depth <= 0.0 || distance >= least) continue;
      best = start;
      least = distance;
    }
  }
  return best;
}

}  // namespace

std::optional<GridPosition> RayGrid::locate(const Vec3& p) const {
  return locate(p, {0.5 * (rows_ - 1), 0.5 * (columns_ - 1)});
}

std::optional<GridPosition> RayGrid::locate(const Vec3& p, const GridPosition& hint) const {
  for (const HalfSpace& bound : bounds_)
    if (!bound.contains(p)) return std::nullopt;
  const GridPosition start{std::clamp(hint.row, 0.0, rows_ - 1.0), std::clamp(hint.column, 0.0, columns_ - 1.0)};
  if (const auto found = descend(*this, p, start)) return found;
  return descend(*this, p, nearestStart(*this, p));
}

}  // namespace vantage
