#include "integration/grid_surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

// The quality rises from the border over this many samples.
constexpr int kBorderRings = 4;
constexpr double kBorderQuality = 0.1;
// Barycentric slack with which a place on an edge belongs to either side.
constexpr double kEdgeSlack = 1e-9;

// Samples from every ray to the nearest one where `isBorder`, diagonals counting one, up to kBorderRings.
std::vector<int> ringsFromBorder(const RayGrid& rays, const std::vector<std::uint8_t>& isBorder) {
  const int rows = rays.rows();
  const int columns = rays.columns();
  std::vector<int> rings(rays.size());
  for (std::size_t i = 0; i < rings.size(); ++i) rings[i] = isBorder[i] ? 0 : kBorderRings;
  const auto relax = [&](int r, int c, int dr, int dc) {
    if (r + dr < 0 || r + dr >= rows || c + dc < 0 || c + dc >= columns) return;
    int& here = rings[rays.index(r, c)];
    here = std::min(here, rings[rays.index(r + dr, c + dc)] + 1);
  };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      for (const auto& [dr, dc] : {std::pair{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}}) relax(r, c, dr, dc);
  for (int r = rows - 1; r >= 0; --r)
    for (int c = columns - 1; c >= 0; --c)
      for (const auto& [dr, dc] : {std::pair{1, 1}, {1, 0}, {1, -1}, {0, 1}}) relax(r, c, dr, dc);
  return rings;
}

}  // namespace

GridSurface::GridSurface(const View& view)
    : image_(view.image),
      mesh_(view.mesh),
      T_object_scanner_(view.T_object_scanner),
      T_scanner_object_(view.T_object_scanner.inverse()) {
  if (!image_ || !image_->rays || !mesh_) throw InvalidInput("a view without range image or mesh cannot be integrated");
  const int largest = std::max(rays().rows(), rays().columns());
  if (largest > kPlaneLimit / kPlaneCell - 2)
    throw InvalidInput("a ray grid of " + std::to_string(largest) +
                       " rays along one side is too large to be integrated");
  fillCells();
  rateVertices();
  boundRays();
}

void GridSurface::fillCells() {
  cells_.assign(rays().size(), {kNoIndex, kNoIndex});
  const auto columns = static_cast<std::uint32_t>(rays().columns());
  for (std::uint32_t t = 0; t < mesh_->mesh.triangles.size(); ++t) {
    std::uint32_t row = kNoIndex;
    std::uint32_t column = kNoIndex;
    for (const std::uint32_t v : mesh_->mesh.triangles[t]) {
      row = std::min(row, mesh_->sample[v] / columns);
      column = std::min(column, mesh_->sample[v] % columns);
    }
    auto& cell = cells_[row * columns + column];
    cell[cell[0] == kNoIndex ? 0 : 1] = t;
  }
  if (mesh_->mesh.triangles.empty()) return;
  const Triangle& t = mesh_->mesh.triangles[0];
  if (orientation(planePoint(mesh_->sample[t[0]]), planePoint(mesh_->sample[t[1]]), planePoint(mesh_->sample[t[2]])) <
      0)
    columnSign_ = -1;
}

void GridSurface::rateVertices() {
  std::vector<std::uint8_t> isBorder(rays().size(), 1);
  for (std::size_t v = 0; v < mesh_->sample.size(); ++v) isBorder[mesh_->sample[v]] = mesh_->onBoundary[v];
  const std::vector<int> rings = ringsFromBorder(rays(), isBorder);
  quality_.resize(mesh_->sample.size());
  for (std::size_t v = 0; v < quality_.size(); ++v) {
    const double inside = static_cast<double>(rings[mesh_->sample[v]]) / kBorderRings;
    quality_[v] = static_cast<float>(mesh_->confidence[v] * (kBorderQuality + (1.0 - kBorderQuality) * inside));
  }
}

void GridSurface::boundRays() {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < rays().size(); ++i) sum += rays().ray(i).direction;
  if (sum.isZero()) return;
  meanRay_ = sum.normalized();
  double least = 1.0;
  for (std::size_t i = 0; i < rays().size(); ++i) least = std::min(least, meanRay_.dot(rays().ray(i).direction));
  // Rays between grid points, and just outside of it, may lie a little farther off.
  constexpr double kSlack = radians(1.0);
  rayCone_ = std::acos(std::clamp(least, -1.0, 1.0)) + kSlack;
}

std::optional<GridContact> GridSurface::at(const GridPosition& position) const {
  const int row = std::clamp(static_cast<int>(std::floor(position.row)), 0, rays().rows() - 2);
  const int column = std::clamp(static_cast<int>(std::floor(position.column)), 0, rays().columns() - 2);
  for (const std::uint32_t t : cell(row, column)) {
    if (t == kNoIndex) return std::nullopt;
    std::array<Vec2, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const auto sample = static_cast<int>(mesh_->sample[mesh_->mesh.triangles[t][k]]);
      const int sampleRow = sample / rays().columns();
      corner[k] = Vec2(sample % rays().columns() - position.column, sampleRow - position.row);
    }
    const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
    GridContact contact{t, {cross(corner[1], corner[2]), cross(corner[2], corner[0]), cross(corner[0], corner[1])}};
    const double whole = contact.weights[0] + contact.weights[1] + contact.weights[2];
    for (double& w : contact.weights) w /= whole;
    if (*std::min_element(contact.weights.begin(), contact.weights.end()) >= -kEdgeSlack) return contact;
  }
  return std::nullopt;
}

double GridSurface::quality(const GridContact& contact) const {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += contact.weights[k] * quality_[mesh_->mesh.triangles[contact.triangle][k]];
  return sum;
}

double GridSurface::confidence(const GridContact& contact) const {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += contact.weights[k] * mesh_->confidence[mesh_->mesh.triangles[contact.triangle][k]];
  return sum;
}

Vec3 GridSurface::normal(const GridContact& contact) const {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) sum += contact.weights[k] * mesh_->normals[mesh_->mesh.triangles[contact.triangle][k]];
  return sum.normalized();
}

GridSurface::CellRange GridSurface::cellsUnder(const PlanePoint& low, const PlanePoint& high) const {
  const auto cell = [](std::int32_t v) { return v >= 0 ? v / kPlaneCell : -((kPlaneCell - 1 - v) / kPlaneCell); };
  const int left = columnSign_ > 0 ? low.x : -high.x;
  const int right = columnSign_ > 0 ? high.x : -low.x;
  return {std::max(cell(low.y), 0), std::min(cell(high.y), rays().rows() - 1), std::max(cell(left), 0),
          std::min(cell(right), rays().columns() - 1)};
}

PlanePoint GridSurface::planePoint(const GridPosition& position) const {
  return {columnSign_ * static_cast<std::int32_t>(std::lround(position.column * kPlaneCell)),
          static_cast<std::int32_t>(std::lround(position.row * kPlaneCell))};
}

GridPosition GridSurface::centreOf(const PlanePoint (&t)[3]) const {
  constexpr double kScale = 1.0 / (3.0 * kPlaneCell);
  return {kScale * (static_cast<double>(t[0].y) + t[1].y + t[2].y),
          columnSign_ * kScale * (static_cast<double>(t[0].x) + t[1].x + t[2].x)};
}

PlanePoint GridSurface::planePoint(std::uint32_t sample) const {
  const auto columns = static_cast<std::uint32_t>(rays().columns());
  return {columnSign_ * static_cast<std::int32_t>(sample % columns) * kPlaneCell,
          static_cast<std::int32_t>(sample / columns) * kPlaneCell};
}

}  // namespace vantage
