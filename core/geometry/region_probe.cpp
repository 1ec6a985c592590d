#include "geometry/region_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/content_hash.h"

namespace vantage {
namespace {

// What is farther out than this [cells] is counted at the border: points of a scanner never are.
constexpr double kMostCells = 1e9;

bool isIn(const BelowPlane& region, const Vec3& p, double margin) {
  return (p - region.point).dot(region.normal) <= margin;
}

bool isIn(const OrientedBox& region, const Vec3& p, double margin) {
  const Vec3 inBox = region.T_region_box.inverse() * p;
  const Vec3 beyond = (inBox.cwiseAbs() - 0.5 * region.size).cwiseMax(0.0);
  return beyond.norm() <= margin;
}

// Even-odd rule.
bool covers(const std::vector<Vec2>& corners, const Vec2& p) {
  bool in = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) in = !in;
  }
  return in;
}

double distanceToLine(const std::vector<Vec2>& corners, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vec2 along = corners[i] - corners[j];
    const double length = along.squaredNorm();
    const double t = length > 0.0 ? std::clamp((p - corners[j]).dot(along) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, (corners[j] + t * along - p).norm());
  }
  return least;
}

bool isIn(const Prism& region, const Vec3& p, double margin) {
  const Vec3 seen = region.T_region_eye.inverse() * p;
  const double depth = -seen.z();
  if (depth < region.nearest - margin || depth > region.farthest + margin) return false;
  if (region.perspective && depth <= 0.0) return false;
  const double scale = region.perspective ? 1.0 / depth : 1.0;
  const Vec2 at = scale * seen.head<2>();
  return covers(region.corners, at) || (margin > 0.0 && distanceToLine(region.corners, at) <= scale * margin);
}

}  // namespace

std::size_t RegionProbe::CellHash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int32_t k : cell) hash = mixedBits(hash * 0x9e3779b97f4a7c15ULL + static_cast<std::uint32_t>(k));
  return hash;
}

RegionProbe::RegionProbe(Region region) : region_(std::move(region)) {
  validate(region_);
  if (const auto* near = std::get_if<NearPoints>(&region_))
    for (std::uint32_t i = 0; i < near->points.size(); ++i) cells_[cellOf(near->points[i])].push_back(i);
}

RegionProbe::Cell RegionProbe::cellOf(const Vec3& p) const {
  const double side = std::get<NearPoints>(region_).radius;
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k)
    cell.at(k) = static_cast<std::int32_t>(
        std::floor(std::clamp(p[static_cast<Eigen::Index>(k)] / side, -kMostCells, kMostCells)));
  return cell;
}

bool RegionProbe::isNear(const NearPoints& region, const Vec3& p, double margin) const {
  const double reach = region.radius + margin;
  const Vec3 wide = Vec3::Constant(reach);
  const Cell low = cellOf(p - wide);
  const Cell high = cellOf(p + wide);
  const auto isClose = [&](std::uint32_t i) { return (region.points[i] - p).squaredNorm() <= reach * reach; };
  for (std::int32_t x = low[0]; x <= high[0]; ++x)
    for (std::int32_t y = low[1]; y <= high[1]; ++y)
      for (std::int32_t z = low[2]; z <= high[2]; ++z)
        if (const auto cell = cells_.find({x, y, z}); cell != cells_.end())
          if (std::any_of(cell->second.begin(), cell->second.end(), isClose)) return true;
  return false;
}

bool RegionProbe::holds(const Vec3& p, double margin) const {
  if (!p.allFinite()) return false;
  if (const auto* near = std::get_if<NearPoints>(&region_)) return isNear(*near, p, margin);
  if (const auto* box = std::get_if<OrientedBox>(&region_)) return isIn(*box, p, margin);
  if (const auto* prism = std::get_if<Prism>(&region_)) return isIn(*prism, p, margin);
  return isIn(std::get<BelowPlane>(region_), p, margin);
}

}  // namespace vantage
