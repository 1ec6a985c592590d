#include "registration/view_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "registration/registration_target.h"

namespace vantage {
namespace {

// The two ways to cut the cell a b / d e (rows down, columns right) along its diagonals ae and bd.
constexpr std::uint8_t kAbe = 1;
constexpr std::uint8_t kAed = 2;
constexpr std::uint8_t kAbd = 4;
constexpr std::uint8_t kBed = 8;

// Rays to each side that must have met nothing for a place to be empty.
constexpr int kAround = 2;

// For every cell of the grid the triangles that it has.
std::vector<std::uint8_t> trianglesOfCells(const ViewMesh& view, const RayGrid& rays) {
  std::vector<std::uint8_t> cells(rays.size(), 0);
  const auto columns = static_cast<std::uint32_t>(rays.columns());
  for (const Triangle& t : view.mesh.triangles) {
    std::array<std::uint32_t, 3> rows{};
    std::array<std::uint32_t, 3> cols{};
    for (int k = 0; k < 3; ++k) {
      rows[k] = view.sample[t[k]] / columns;
      cols[k] = view.sample[t[k]] % columns;
    }
    const std::uint32_t row = *std::min_element(rows.begin(), rows.end());
    const std::uint32_t col = *std::min_element(cols.begin(), cols.end());
    unsigned corners = 0;  // one bit each for a, b, d, e
    for (int k = 0; k < 3; ++k) corners |= 1U << (2 * (rows[k] - row) + (cols[k] - col));
    std::uint8_t& cell = cells[row * columns + col];
    if (corners == 0b1011) cell |= kAbe;
    if (corners == 0b1101) cell |= kAed;
    if (corners == 0b0111) cell |= kAbd;
    if (corners == 0b1110) cell |= kBed;
  }
  return cells;
}

// Robust estimate from each vertex's height above the mean of its neighbours, which has variance s^2 (1 + 1/k).
double sampleNoise(const Mesh& mesh, const std::vector<Vec3>& normals, const std::vector<std::uint8_t>& onBorder) {
  std::vector<Vec3> sum(mesh.vertices.size(), Vec3::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      sum[t[k]] += mesh.vertices[t[(k + 1) % 3]];
      ++count[t[k]];
    }
  }
  std::vector<double> heights;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (onBorder[v] != 0 || count[v] < 3) continue;
    const double height = normals[v].dot(mesh.vertices[v] - sum[v] / count[v]);
    heights.push_back(std::abs(height) / std::sqrt(1.0 + 1.0 / count[v]));
  }
  if (heights.empty()) return 0.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return 1.4826 * *middle;
}

}  // namespace

ViewSurface::ViewSurface(const ViewMesh& view, const RayGrid& rays)
    : view_(&view),
      rays_(&rays),
      cells_(std::make_shared<const std::vector<std::uint8_t>>(trianglesOfCells(view, rays))),
      normals_(std::make_shared<const std::vector<Vec3>>(smoothedNormals(view.mesh))) {
  noise_ = sampleNoise(view.mesh, *normals_, view.onBoundary);
}

OrientedVertices ViewSurface::pointsInside(std::size_t most) const {
  std::vector<std::uint32_t> inside = verticesInside(*normals_, view_->onBoundary);
  if (inside.size() > most) {
    std::vector<std::uint32_t> some = thinned(allIndices(inside.size()), most);
    for (std::uint32_t& k : some) k = inside[k];
    inside = std::move(some);
  }
  return {view_->mesh.vertices, normals_, view_->confidence, std::move(inside)};
}

bool ViewSurface::isEmptyAround(const GridPosition& position) const {
  const int row = static_cast<int>(std::lround(position.row));
  const int column = static_cast<int>(std::lround(position.column));
  if (row < kAround || column < kAround || row >= rays_->rows() - kAround || column >= rays_->columns() - kAround)
    return false;
  for (int r = row - kAround; r <= row + kAround; ++r)
    for (int c = column - kAround; c <= column + kAround; ++c)
      if (view_->vertexOfSample[rays_->index(r, c)] != kNoIndex) return false;
  return true;
}

std::optional<SurfaceSample> ViewSurface::sample(const Vec3& p, std::optional<GridPosition>& position) const {
  position = position ? rays_->locate(p, *position) : rays_->locate(p);
  if (!position) return std::nullopt;
  const int row = std::clamp(static_cast<int>(std::floor(position->row)), 0, rays_->rows() - 2);
  const int col = std::clamp(static_cast<int>(std::floor(position->column)), 0, rays_->columns() - 2);
  const std::size_t a = rays_->index(row, col);
  const std::uint8_t cell = (*cells_)[a];
  if (cell == 0) return std::nullopt;
  const double u = position->column - col;
  const double v = position->row - row;
  if (u < 0.0 || v < 0.0 || u > 1.0 || v > 1.0) return std::nullopt;

  const std::size_t b = a + 1;
  const std::size_t d = a + static_cast<std::size_t>(rays_->columns());
  const std::size_t e = d + 1;
  std::array<std::size_t, 3> corners{};
  Vec3 weights;
  if ((cell & kAbe) != 0 && u >= v) {
    corners = {a, b, e};
    weights = {1.0 - u, u - v, v};
  } else if ((cell & kAed) != 0 && v >= u) {
    corners = {a, e, d};
    weights = {1.0 - v, u, v - u};
  } else if ((cell & kAbd) != 0 && u + v <= 1.0) {
    corners = {a, b, d};
    weights = {1.0 - u - v, u, v};
  } else if ((cell & kBed) != 0 && u + v >= 1.0) {
    corners = {b, e, d};
    weights = {1.0 - v, u + v - 1.0, 1.0 - u};
  } else {
    return std::nullopt;
  }

  SurfaceSample found;
  found.direction = rays_->ray(corners[0]).direction;
  found.inside = true;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t vertex = view_->vertexOfSample[corners[k]];
    found.point += weights[k] * view_->mesh.vertices[vertex];
    found.normal += weights[k] * (*normals_)[vertex];
    found.confidence += static_cast<float>(weights[k]) * view_->confidence[vertex];
    found.inside = found.inside && view_->onBoundary[vertex] == 0;
  }
  found.normal.normalize();
  return found;
}

}  // namespace vantage
