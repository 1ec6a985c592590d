#include "composites/composite_surface.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/measures.h"
#include "geometry/mesh_border.h"
#include "registration/registration_target.h"

namespace vantage {
namespace {

constexpr int kCurveBits = 10;

// Places along a curve that fills the box: near places are mostly near each other on it.
std::uint32_t curvePlace(const Vec3& p, const BoundingBox& box) {
  const Vec3 share = (p - box.min) / std::max(box.size().maxCoeff(), 1e-9);
  std::uint32_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint32_t>(share[axis] * ((1 << kCurveBits) - 1));
    for (int bit = 0; bit < kCurveBits; ++bit) place |= ((cell >> bit) & 1U) << (3 * bit + axis);
  }
  return place;
}

}  // namespace

CompositeSurface::CompositeSurface(const Mesh& mesh) : points_(mesh.vertices), area_(mesh.vertices.size(), 0.0) {
  validate(mesh);
  normals_ = smoothedNormals(mesh);
  inside_ = borderVertices(mesh);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(6 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const double third = triangleArea(mesh, t) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) {
      area_[t[k]] += third;
      edges.emplace_back(t[k], t[(k + 1) % 3]);
      edges.emplace_back(t[(k + 1) % 3], t[k]);
    }
  }
  for (std::size_t v = 0; v < inside_.size(); ++v)
    inside_[v] = inside_[v] == 0 && normals_[v].squaredNorm() > 0.5 ? 1 : 0;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  firstNeighbour_.assign(points_.size() + 1, 0);
  neighbours_.reserve(edges.size());
  for (const auto& [from, to] : edges) {
    ++firstNeighbour_[from + 1];
    neighbours_.push_back(to);
  }
  std::partial_sum(firstNeighbour_.begin(), firstNeighbour_.end(), firstNeighbour_.begin());
}

std::uint32_t CompositeSurface::walkTo(const Vec3& p, std::uint32_t from) const {
  double least = (points_[from] - p).squaredNorm();
  while (true) {
    std::uint32_t nearest = from;
    for (std::uint32_t k = firstNeighbour_[from]; k < firstNeighbour_[from + 1]; ++k) {
      const double distance = (points_[neighbours_[k]] - p).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = neighbours_[k];
    }
    if (nearest == from) return from;
    from = nearest;
  }
}

std::vector<std::uint32_t> CompositeSurface::spread(std::size_t count) const {
  BoundingBox box;
  if (!points_.empty()) box = {points_.front(), points_.front()};
  for (const Vec3& p : points_) box.extend(p);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  double all = 0.0;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (inside_[v] == 0) continue;
    order.emplace_back(curvePlace(points_[v], box), v);
    all += area_[v];
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> chosen;
  const double step = all / static_cast<double>(std::max<std::size_t>(count, 1));
  double passed = 0.0;
  double next = 0.5 * step;
  for (const auto& [place, v] : order) {
    passed += area_[v];
    if (passed < next) continue;
    chosen.push_back(v);
    while (next <= passed) next += step;
  }
  return chosen;
}

CompositeSurface CompositeSurface::moved(std::span<const Pose> motions, std::span<const std::uint32_t> motionOf) const {
  CompositeSurface other = *this;
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const Pose& motion = motions[motionOf[v]];
    other.points_[v] = motion * points_[v];
    other.normals_[v] = motion.linear() * normals_[v];
  }
  return other;
}

}  // namespace vantage
