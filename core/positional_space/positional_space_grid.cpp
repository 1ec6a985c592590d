#include "positional_space/positional_space_grid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

// A ray may end this far beyond a rim and still belong to the last row [mm].
constexpr double kRimTolerance = 1e-6;

SurfaceCell cylinderCell(const PositionalSpaceShape& shape, int row, int column) {
  const double height = (shape.top - shape.bottom) / shape.rows;
  const double a = shape.firstColumn + 2.0 * kPi * (column + 0.5) / shape.columns;
  SurfaceCell cell;
  cell.normal = Vec3(std::cos(a), std::sin(a), 0.0);
  cell.across = Vec3(-std::sin(a), std::cos(a), 0.0);
  cell.up = Vec3::UnitZ();
  cell.centre = shape.radius * cell.normal + (shape.bottom + (row + 0.5) * height) * Vec3::UnitZ();
  cell.halfWidth = kPi * shape.radius / shape.columns;
  cell.halfHeight = 0.5 * height;
  return cell;
}

SurfaceCell sphereCell(const PositionalSpaceShape& shape, int row, int column) {
  const double latitude = kPi * ((row + 0.5) / shape.rows - 0.5);
  const double a = shape.firstColumn + 2.0 * kPi * (column + 0.5) / shape.columns;
  SurfaceCell cell;
  const Vec3 outward(std::cos(a), std::sin(a), 0.0);
  cell.normal = std::cos(latitude) * outward + std::sin(latitude) * Vec3::UnitZ();
  cell.across = Vec3(-std::sin(a), std::cos(a), 0.0);
  cell.up = -std::sin(latitude) * outward + std::cos(latitude) * Vec3::UnitZ();
  cell.centre = shape.radius * cell.normal + 0.5 * (shape.bottom + shape.top) * Vec3::UnitZ();
  cell.halfWidth = kPi * shape.radius * std::cos(latitude) / shape.columns;
  cell.halfHeight = 0.5 * kPi * shape.radius / shape.rows;
  cell.taper = std::tan(latitude) / shape.radius;
  return cell;
}

// Index of the cell that a fraction of a full range falls into.
int cellOf(double fraction, int cells) {
  return std::clamp(static_cast<int>(std::floor(fraction * cells)), 0, cells - 1);
}

int columnOf(const Vec3& p, const PositionalSpaceShape& shape) {
  const double turn = (std::atan2(p.y(), p.x()) - shape.firstColumn) / (2.0 * kPi);
  return cellOf(turn - std::floor(turn), shape.columns);
}

// Distance along the ray at which it leaves a ball (dimension 3) or an infinite cylinder about z (dimension 2).
std::optional<double> exitDistance(const OutwardRay& ray, const Vec3& centre, double radius, int dimension) {
  const Vec3 p = ray.point - centre;
  const double a = ray.direction.head(dimension).squaredNorm();
  const double b = p.head(dimension).dot(ray.direction.head(dimension));
  const double c = p.head(dimension).squaredNorm() - radius * radius;
  const double root = b * b - a * c;
  if (root < 0.0 || a < 1e-18) return std::nullopt;
  return (-b + std::sqrt(root)) / a;
}

}  // namespace

PositionalSpaceGrid::PositionalSpaceGrid(const PositionalSpaceShape& shape) : shape_(shape) {
  if (shape.rows < 1 || shape.columns < 3 || shape.columns > kMostColumns || shape.directions < 1)
    throw InvalidInput("positional space of " + std::to_string(shape.rows) + " rows, " + std::to_string(shape.columns) +
                       " columns and " + std::to_string(shape.directions) +
                       " directions cannot be: at least 1 x 3 x 1 and at most " + std::to_string(kMostColumns) +
                       " columns are needed");
  if (!(shape.radius > 0.0 && std::isfinite(shape.radius) && shape.top > shape.bottom &&
        std::isfinite(shape.top - shape.bottom) && std::isfinite(shape.firstColumn)))
    throw InvalidInput("positional space of radius " + std::to_string(shape.radius) + " mm from z = " +
                       std::to_string(shape.bottom) + " to " + std::to_string(shape.top) + " mm has no size");
  cells_.reserve(static_cast<std::size_t>(shape.rows) * static_cast<std::size_t>(shape.columns));
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column)
      cells_.push_back(shape.surface == PositionalSpaceSurface::Cylinder ? cylinderCell(shape, row, column)
                                                                         : sphereCell(shape, row, column));
}

std::optional<PositionalCell> PositionalSpaceGrid::project(const OutwardRay& ray) const {
  const bool cylinder = shape_.surface == PositionalSpaceSurface::Cylinder;
  const Vec3 centre = cylinder ? Vec3(Vec3::Zero()) : Vec3(0.0, 0.0, 0.5 * (shape_.bottom + shape_.top));
  const auto distance = exitDistance(ray, centre, shape_.radius, cylinder ? 2 : 3);
  if (!distance) return std::nullopt;
  const Vec3 p = ray.point + *distance * ray.direction - centre;
  int row = 0;
  if (cylinder) {
    if (p.z() < shape_.bottom - kRimTolerance || p.z() > shape_.top + kRimTolerance) return std::nullopt;
    row = cellOf((p.z() - shape_.bottom) / (shape_.top - shape_.bottom), shape_.rows);
  } else {
    row = cellOf(std::asin(std::clamp(p.z() / shape_.radius, -1.0, 1.0)) / kPi + 0.5, shape_.rows);
  }
  const int column = columnOf(p, shape_);
  PositionalCell cell = directionCell(surfaceCell(row, column), ray.direction);
  cell.row = row;
  cell.column = column;
  return cell;
}

PositionalCell PositionalSpaceGrid::directionCell(const SurfaceCell& cell, const Vec3& direction) const {
  const double phi = std::atan2(direction.dot(cell.across), direction.dot(cell.normal));
  const double psi = std::asin(std::clamp(direction.dot(cell.up), -1.0, 1.0));
  PositionalCell found;
  // Near a cell's border a ray may leave slightly behind the plane of its middle: it belongs to the outermost cell.
  found.phi = cellOf(phi / kPi + 0.5, shape_.directions);
  found.psi = cellOf(psi / kPi + 0.5, shape_.directions);
  return found;
}

OutwardRay PositionalSpaceGrid::unproject(const PositionalCell& cell) const {
  const SurfaceCell& s = surfaceCell(cell.row, cell.column);
  const double phi = ((cell.phi + 0.5) / shape_.directions - 0.5) * kPi;
  const double psi = ((cell.psi + 0.5) / shape_.directions - 0.5) * kPi;
  const Vec3 horizontal = std::cos(phi) * s.normal + std::sin(phi) * s.across;
  return {s.centre, std::cos(psi) * horizontal + std::sin(psi) * s.up};
}

}  // namespace vantage
