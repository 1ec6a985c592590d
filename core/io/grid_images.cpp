#include "io/grid_images.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/mesh.h"

namespace vantage {
namespace {

constexpr double kSectorAngle = 0.5 * kPi;
constexpr double kSectorOverlap = kPi / 8.0;

// The rotation that brings a direction to -z. The identity changes no bit.
Eigen::Matrix3d turnToMinusZ(const Vec3& sight) {
  if (sight == -Vec3::UnitZ()) return Eigen::Matrix3d::Identity();
  if (sight == Vec3::UnitZ()) return Vec3(1, -1, -1).asDiagonal();
  return Eigen::Quaterniond::FromTwoVectors(sight, -Vec3::UnitZ()).toRotationMatrix();
}

std::vector<float> rangesOf(const SampleGrid& grid, const std::vector<RangingRay>& rays) {
  std::vector<float> range(rays.size(), kNoSample);
  for (std::size_t k = 0; k < rays.size(); ++k)
    if (grid.cell[k] != kNoIndex) range[k] = static_cast<float>((grid.points[grid.cell[k]] - rays[k].origin).norm());
  return range;
}

std::vector<Colour> coloursOf(const SampleGrid& grid) {
  if (grid.colours.empty()) return {};
  std::vector<Colour> colours(grid.cell.size(), Colour{});
  for (std::size_t k = 0; k < colours.size(); ++k)
    if (grid.cell[k] != kNoIndex) colours[k] = grid.colours[grid.cell[k]];
  return colours;
}

RangeImage imageOf(const SampleGrid& grid, std::vector<RangingRay> rays) {
  RangeImage image;
  image.range = rangesOf(grid, rays);
  image.colours = coloursOf(grid);
  image.rays = std::make_shared<const RayGrid>(grid.rows, grid.columns, std::move(rays), std::vector<Vec3>{}, 0);
  return image;
}

// Some columns of an image, going on at its first column behind column `period`.
RangeImage columnsOf(const RangeImage& image, int first, int count, int period) {
  RangeImage part;
  std::vector<RangingRay> rays;
  for (int r = 0; r < image.rays->rows(); ++r) {
    for (int k = 0; k < count; ++k) {
      const std::size_t i = image.rays->index(r, ((first + k) % period + period) % period);
      rays.push_back(image.rays->ray(i));
      part.range.push_back(image.range[i]);
      if (!image.colours.empty()) part.colours.push_back(image.colours[i]);
    }
  }
  part.rays = std::make_shared<const RayGrid>(image.rays->rows(), count, std::move(rays), std::vector<Vec3>{}, 0);
  return part;
}

}  // namespace

RangeImage imageAlong(const SampleGrid& grid, const Vec3& sight, double standoff) {
  const Eigen::Matrix3d turn = turnToMinusZ(sight);
  SampleGrid turned = grid;
  if (!turn.isIdentity(0.0))
    for (Vec3& p : turned.points) p = turn * p;
  double top = turned.points.front().z();
  for (const Vec3& p : turned.points) top = std::max(top, p.z());
  std::vector<RangingRay> rays = reconstructRays(turned, top + standoff);
  RangeImage image = imageOf(turned, rays);
  if (turn.isIdentity(0.0)) return image;
  for (RangingRay& ray : rays) ray = {turn.transpose() * ray.origin, (turn.transpose() * ray.direction).normalized()};
  image.rays = std::make_shared<const RayGrid>(grid.rows, grid.columns, std::move(rays), std::vector<Vec3>{}, 0);
  return image;
}

RangeImage imageFromOrigin(const SampleGrid& grid, const TurnSight& turn) {
  return imageOf(grid, pointRays(grid, turn));
}

std::vector<RangeImage> imagesOfTurn(const SampleGrid& grid, const TurnSight& turn, double standoff) {
  double radius = 0.0;
  const int axis = static_cast<int>(turn.axis);
  for (const Vec3& p : grid.points) radius = std::max(radius, std::hypot(p[(axis + 1) % 3], p[(axis + 2) % 3]));
  const RangeImage whole = imageOf(grid, turntableRays(grid, turn, radius + standoff));
  const int around = static_cast<int>(std::lround(2.0 * kPi / std::abs(turn.step)));
  const bool closed = around <= grid.columns;
  const int period = closed ? around : grid.columns;
  const int sectors = std::max(1, static_cast<int>(std::ceil(period * std::abs(turn.step) / kSectorAngle - 1e-6)));
  const int beside = static_cast<int>(std::ceil(kSectorOverlap / std::abs(turn.step)));
  std::vector<RangeImage> images;
  for (int s = 0; s < sectors; ++s) {
    int first = period * s / sectors - beside;
    int end = period * (s + 1) / sectors + beside;
    if (!closed) first = std::max(first, 0);
    if (!closed) end = std::min(end, period);
    images.push_back(columnsOf(whole, first, end - first, period));
  }
  return images;
}

RangeImage imageOnRays(const SampleGrid& grid, const std::shared_ptr<const RayGrid>& rays, OffRays& off) {
  RangeImage image;
  image.range.assign(rays->size(), kNoSample);
  for (std::size_t k = 0; k < rays->size(); ++k) {
    if (grid.cell[k] == kNoIndex) continue;
    const Vec3 offset = grid.points[grid.cell[k]] - rays->ray(k).origin;
    const double range = offset.dot(rays->ray(k).direction);
    const double aside = (offset - range * rays->ray(k).direction).norm();
    if (range < 0.0 || aside > std::max(1.0, 0.01 * range)) {
      off = {k, aside};
      return {};
    }
    image.range[k] = static_cast<float>(range);
  }
  image.rays = rays;
  image.colours = coloursOf(grid);
  return image;
}

}  // namespace vantage
