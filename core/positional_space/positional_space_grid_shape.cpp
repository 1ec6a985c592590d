#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "positional_space/positional_space_grid.h"
#include "positional_space/ray_fan.h"

namespace vantage {
namespace {

// The surface lies this much outside of the viewing volume, so that no surface point touches it.
constexpr double kClearance = 1.03;
// A cylinder taller than this many viewing volumes is given up for a sphere.
constexpr double kTallest = 2.0;
// The lower and the upper rim lie this much of a row outside, and the first column begins this much of a column off the
// x axis: borders between cells keep off round heights and planes of symmetry, where rounding would decide for whole
// faces of an object which cell their rays belong to, or none.
constexpr double kLowerRim = 0.031;
constexpr double kUpperRim = 0.047;
constexpr double kFirstColumn = 0.283;
// Direction cells over pi: at most, at least, and by how many the narrowest angle between rays of a cell is divided
// where positions are so dense that they have to share direction cells.
constexpr int kMostDirections = 361;
constexpr int kFewestDirections = 19;
constexpr double kSharedParts = 3.0;
// Positions whose rays differ by no more than rays of one surface cell do: more than this many are dense.
constexpr double kDense = 3.0;
// Where that is looked at.
constexpr std::size_t kDensityCells = 24;
constexpr std::size_t kDensityPoses = 4000;

// Poses of which the others are turns about z: positional space looks the same for those.
std::vector<Pose> posesUpToTurns(const Workspace& workspace) {
  std::vector<Pose> poses;
  const std::size_t step = workspace.steps > 0 ? static_cast<std::size_t>(workspace.steps) : 1;
  for (std::size_t i = 0; i < workspace.poses.size(); i += step) poses.push_back(workspace.poses[i]);
  return poses;
}

// Whether a line meets the viewing volume (a tolerance outside counts, so that rays along its rims do).
bool meets(const ViewingVolume& volume, const Vec3& p, const Vec3& d) {
  const double tolerance = 1e-9 * (volume.radius + volume.height);
  const double radius = volume.radius + tolerance;
  const double a = d.head<2>().squaredNorm();
  const double b = p.head<2>().dot(d.head<2>());
  const double c = p.head<2>().squaredNorm() - radius * radius;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  if (a > 1e-18) {
    const double root = b * b - a * c;
    if (root < 0.0) return false;
    from = (-b - std::sqrt(root)) / a;
    to = (-b + std::sqrt(root)) / a;
  } else if (c > 0.0) {
    return false;
  }
  if (std::abs(d.z()) < 1e-12) return p.z() >= -tolerance && p.z() <= volume.height + tolerance;
  const double low = (-tolerance - p.z()) / d.z();
  const double high = (volume.height + tolerance - p.z()) / d.z();
  return std::max(from, std::min(low, high)) <= std::min(to, std::max(low, high));
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
};

// Heights at which the rays that meet the viewing volume leave the infinite cylinder; infinite for vertical rays.
Extent crossingHeights(const ScannerProfile& profile, const std::vector<Pose>& poses, double radius,
                       const Progress& progress) {
  std::vector<Extent> extents(poses.size());
  const auto rays = usefulRays(profile.rays);
  parallelChunks(poses.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < rays->size(); ++k) {
        const RangingRay ray = rays->ray(k);
        const Vec3 p = poses[i] * ray.origin;
        const Vec3 d = -(poses[i].linear() * ray.direction);
        if (!meets(profile.viewingVolume, p, d)) continue;
        const double a = d.head<2>().squaredNorm();
        const double b = p.head<2>().dot(d.head<2>());
        const double root = std::max(0.0, b * b - a * (p.head<2>().squaredNorm() - radius * radius));
        extents[i].add(a > 1e-12 ? p.z() + (-b + std::sqrt(root)) / a * d.z()
                                 : std::numeric_limits<double>::infinity());
      }
    }
  });
  Extent all;
  for (const Extent& e : extents) {
    all.low = std::min(all.low, e.low);
    all.high = std::max(all.high, e.high);
  }
  return all;
}

PositionalSpaceShape sphereShape(const ViewingVolume& volume, int rows, int columns) {
  PositionalSpaceShape shape;
  shape.surface = PositionalSpaceSurface::Sphere;
  shape.rows = rows;
  shape.columns = columns;
  shape.radius = kClearance * std::hypot(volume.radius, 0.5 * volume.height);
  shape.bottom = 0.5 * volume.height - shape.radius;
  shape.top = 0.5 * volume.height + shape.radius;
  return shape;
}

PositionalSpaceShape surfaceShape(const ScannerProfile& profile, const std::vector<Pose>& poses,
                                  const Progress& progress) {
  const ViewingVolume& volume = profile.viewingVolume;
  const PositionalSpaceSize& size = profile.positionalSpace;
  if (size.surface == PositionalSpaceSurface::Sphere) return sphereShape(volume, size.rows, size.columns);

  PositionalSpaceShape shape;
  shape.rows = size.rows;
  shape.columns = size.columns;
  shape.radius = kClearance * volume.radius;
  shape.top = volume.height;
  const Extent needed = crossingHeights(profile, poses, shape.radius, progress);
  const double low = std::min(0.0, needed.low);
  const double high = std::max(volume.height, needed.high);
  const double rowHeight = volume.height / (size.rows - kLowerRim - kUpperRim);
  if (!(high - low <= kTallest * volume.height))
    return sphereShape(volume, std::max(size.rows, static_cast<int>(std::ceil(2.0 * volume.height / rowHeight))),
                       size.columns);
  // Whole rows below and above; a ray along a rim does not ask for one of its own.
  const int below = static_cast<int>(std::ceil(-low / rowHeight - kLowerRim));
  const int above = static_cast<int>(std::ceil((high - volume.height) / rowHeight - kUpperRim));
  shape.rows = size.rows + below + above;
  shape.bottom = -(below + kLowerRim) * rowHeight;
  shape.top = volume.height + (above + kUpperRim) * rowHeight;
  return shape;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Angles by which rays that share a surface cell differ, across and up: from a surface point in the middle of the
// volume to either end of the cell, and from there on to the scanner's head. Medians over the first position's rays.
struct FanWidths {
  double across = radians(10.0);
  double up = radians(10.0);
};

FanWidths fanWidths(const RayFan& fan, const PositionalSpaceShape& shape, const std::vector<Pose>& poses) {
  const PositionalSpaceGrid grid(shape);
  std::vector<double> across;
  std::vector<double> up;
  std::optional<GridPosition> hint;
  for (std::size_t i = 0; i < poses.size() && across.empty(); ++i) {
    for (const SurfaceCell& cell : grid.surfaceCells()) {
      const auto ray = fan.through(cell, poses[i], hint);
      if (!ray) continue;
      auto width = [&](int k, double half) {
        const double change = 2.0 * half * (1.0 / shape.radius + std::abs(ray->fan(k, k)));
        return change / (1.0 + ray->slope[k] * ray->slope[k]);
      };
      across.push_back(width(0, cell.halfWidth));
      up.push_back(width(1, cell.halfHeight));
    }
  }
  if (across.empty()) return {};
  return {median(across), median(up)};
}

// How many positions' rays leave through a surface cell in about the same direction, on average over rays.
double positionDensity(const RayFan& fan, const PositionalSpaceShape& shape, const std::vector<Pose>& poses,
                       const FanWidths& widths) {
  const PositionalSpaceGrid grid(shape);
  const auto& cells = grid.surfaceCells();
  const std::size_t cellStride = std::max<std::size_t>(1, cells.size() / kDensityCells);
  const std::size_t poseStride = (poses.size() + kDensityPoses - 1) / kDensityPoses;
  std::size_t rays = 0;
  std::size_t close = 0;
  for (std::size_t c = 0; c < cells.size(); c += cellStride) {
    std::vector<Vec2> directions;
    std::optional<GridPosition> hint;
    for (std::size_t i = 0; i < poses.size(); i += poseStride)
      if (const auto ray = fan.through(cells[c], poses[i], hint))
        directions.emplace_back(std::atan(ray->slope[0]), std::asin(ray->direction.dot(cells[c].up)));
    rays += directions.size();
    for (const Vec2& a : directions)
      for (const Vec2& b : directions)
        if (std::abs(a[0] - b[0]) < 0.5 * widths.across && std::abs(a[1] - b[1]) < 0.5 * widths.up) ++close;
  }
  return rays == 0 ? 0.0 : static_cast<double>(close * poseStride) / static_cast<double>(rays);
}

}  // namespace

PositionalSpaceGrid makePositionalSpaceGrid(const ScannerProfile& profile, const Progress& progress) {
  const std::vector<Pose> poses = posesUpToTurns(profile.workspace);
  PositionalSpaceShape shape = surfaceShape(profile, poses, progress);
  shape.firstColumn = kFirstColumn * 2.0 * kPi / shape.columns;
  progress.checkpoint(1.0);
  const RayFan fan(profile.rays, 4.0 * shape.radius);
  progress.checkpoint(1.0);
  const FanWidths widths = fanWidths(fan, shape, poses);
  const double narrowest = std::min(widths.across, widths.up);
  const bool dense = positionDensity(fan, shape, profile.workspace.poses, widths) > kDense;
  const int shared = static_cast<int>(std::ceil(kPi / narrowest * kSharedParts)) | 1;
  shape.directions = dense ? std::clamp(shared, kFewestDirections, kMostDirections) : kMostDirections;
  shape.angularError = 0.5 * std::max(widths.across, widths.up) + 0.5 * kPi / shape.directions;
  return PositionalSpaceGrid(shape);
}

}  // namespace vantage
