#include "forecast/free_space.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/measures.h"

namespace vantage {
namespace {

constexpr double kPad = 4.0;            // about the model [sides]
constexpr double kNearSurface = 1.3;    // a voxel this near may lie on the surface [sides] ...
constexpr double kBesideBorder = 0.45;  // ... unless it lies so far beside its border [sides]
constexpr double kDepthMargin = 0.7;    // what is nearer to a sample than this need not be free [sides]
constexpr double kLeastSide = 1e-6;     // [mm]

// Grows the box away from the views until it is as deep as it is wide.
void goOnUnseen(BoundingBox& box, std::span<const View> views) {
  const Vec3 centre = box.centre();
  Vec3 toward = Vec3::Zero();
  for (const View& view : views) {
    const RayGrid& rays = *view.image->rays;
    toward += (view.T_object_scanner * rays.ray(rays.size() / 2).origin - centre).normalized();
  }
  const Vec3 size = box.max - box.min;
  const double widest = std::max(size.x(), size.y());
  for (int axis = 0; axis < 2; ++axis) {
    const double lack = widest - size[axis];
    if (toward[axis] > 0.0)
      box.min[axis] -= lack;
    else
      box.max[axis] += lack;
  }
}

std::array<int, 3> voxelsAcross(const Vec3& size, double side) {
  std::array<int, 3> counts{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    counts[axis] = static_cast<int>(std::ceil(size[static_cast<Eigen::Index>(axis)] / side + 2.0 * kPad)) + 1;
  return counts;
}

// The given side, or the least larger one (to 5 %) at which there are no more voxels than allowed.
double sideFor(const Vec3& size, double side, std::size_t mostVoxels) {
  const double most = std::max(std::pow(2.0 * kPad + 2.0, 3.0), static_cast<double>(mostVoxels));
  side = std::max(side, size.maxCoeff() / most);
  for (;; side *= 1.05) {
    const std::array<int, 3> counts = voxelsAcross(size, side);
    if (static_cast<double>(counts[0]) * counts[1] * counts[2] <= most) return side;
  }
}

VoxelGrid gridAbout(BoundingBox box, double side, std::size_t mostVoxels) {
  VoxelGrid grid;
  grid.side = sideFor(box.size(), side, mostVoxels);
  box.min -= Vec3::Constant(kPad * grid.side);
  box.max += Vec3::Constant(kPad * grid.side);
  grid.low = box.min;
  if (box.min.z() < 0.0 && box.max.z() > 0.0) grid.low.z() = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    grid.counts[axis] = std::max(3, static_cast<int>(std::ceil((box.max[a] - grid.low[a]) / grid.side)));
  }
  return grid;
}

// Voxels that a triangle's box, grown by the distance, reaches.
std::vector<std::uint8_t> nearTriangles(const Mesh& mesh, const VoxelGrid& grid, double distance) {
  std::vector<std::uint8_t> near(grid.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3& b = mesh.vertices[t[1]];
    const Vec3& c = mesh.vertices[t[2]];
    const Vec3 low = (a.cwiseMin(b).cwiseMin(c) - Vec3::Constant(distance) - grid.low) / grid.side;
    const Vec3 high = (a.cwiseMax(b).cwiseMax(c) + Vec3::Constant(distance) - grid.low) / grid.side;
    std::array<int, 3> first{};
    std::array<int, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      first[axis] = std::max(0, static_cast<int>(std::floor(low[i])));
      last[axis] = std::min(grid.counts[axis] - 1, static_cast<int>(std::floor(high[i])));
    }
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int x = first[0]; x <= last[0]; ++x) near[grid.index(x, y, z)] = 1;
  }
  return near;
}

// What the views say of places, one after the other in a row of voxels.
class Carver {
 public:
  Carver(const RayCaster& obstacles, std::span<const View> views, const std::vector<Pose>& T_scanner_object,
         double side, const FreeSpaceOptions& options)
      : obstacles_(obstacles),
        views_(views),
        T_scanner_object_(T_scanner_object),
        margin_(kDepthMargin * side),
        parallel_(std::cos(options.crossingAngle)),
        places_(views.size()) {}

  // Whether the place is free. If not, `silent()` rays measured nothing there.
  bool isFree(const Vec3& p) {
    silent_.clear();
    // A neighbour is most likely free for the same view.
    for (std::size_t k = 0; k < views_.size(); ++k) {
      const std::size_t view = (last_ + k) % views_.size();
      if (!frees(view, p)) continue;
      last_ = view;
      return true;
    }
    return false;
  }

  [[nodiscard]] std::size_t silent() const { return silent_.size(); }

 private:
  bool frees(std::size_t v, const Vec3& p) {
    const View& view = views_[v];
    const RayGrid& rays = *view.image->rays;
    const Vec3 inScanner = T_scanner_object_[v] * p;
    const auto place = places_[v] ? rays.locate(inScanner, *places_[v]) : rays.locate(inScanner);
    if (!place) return false;
    places_[v] = place;
    const std::size_t r = rays.nearest(*place);
    const RangingRay& ray = rays.ray(r);
    const double depth = (inScanner - ray.origin).dot(ray.direction);
    if (view.image->valid(r)) return depth < static_cast<double>(view.image->range[r]) - margin_;
    const Vec3 source = view.T_object_scanner * ray.origin;
    if (obstacles_.occluded(p, source, margin_) || !received(view, r, p)) return false;
    const Vec3 direction = (source - p).normalized();
    const bool crosses = std::any_of(silent_.begin(), silent_.end(),
                                     [&](const Vec3& other) { return std::abs(other.dot(direction)) < parallel_; });
    silent_.push_back(direction);
    return crosses;
  }

  [[nodiscard]] bool received(const View& view, std::size_t ray, const Vec3& p) const {
    const RayGrid& rays = *view.image->rays;
    if (!rays.triangulates()) return true;
    const auto receivers = rays.receivers(ray);
    return std::any_of(receivers.begin(), receivers.end(), [&](const Vec3& receiver) {
      return !obstacles_.occluded(p, view.T_object_scanner * receiver, margin_);
    });
  }

  const RayCaster& obstacles_;
  std::span<const View> views_;
  const std::vector<Pose>& T_scanner_object_;
  double margin_;
  double parallel_;
  std::vector<std::optional<GridPosition>> places_;  // per view: where the place before was in its grid
  std::vector<Vec3> silent_;                         // towards the sources of rays that measured nothing
  std::size_t last_ = 0;
};

// Nothing where the voxel does not lie on the surface.
std::optional<float> levelAt(const Vec3& p, const Mesh& model, const RayCaster& obstacles, double side) {
  const auto nearest = obstacles.closestPoint(p, kNearSurface * side);
  if (!nearest) return std::nullopt;
  const Vec3 normal = triangleNormal(model, model.triangles[nearest->triangle]);
  const Vec3 offset = p - nearest->point;
  const double height = offset.dot(normal);
  if ((offset - height * normal).norm() >= kBesideBorder * side) return std::nullopt;
  return static_cast<float>(std::clamp(height / side, -1.0, 1.0));
}

bool isOutermost(const FreeSpace& space, int x, int y, int z) {
  const auto& n = space.grid.counts;
  const bool below = z == 0 && !space.onTable;
  return x == 0 || y == 0 || below || x == n[0] - 1 || y == n[1] - 1 || z == n[2] - 1;
}

}  // namespace

FreeSpace carveFreeSpace(const Mesh& model, const RayCaster& obstacles, std::span<const View> views,
                         const FreeSpaceOptions& options, const Progress& progress) {
  if (model.empty()) throw InvalidInput("the space about a model of 0 triangles cannot be carved");
  if (!(options.side >= kLeastSide))
    throw InvalidInput("voxels have a side of " + std::to_string(options.side) + " mm, expected more than 0");
  BoundingBox box = boundingBox(model);
  goOnUnseen(box, views);
  FreeSpace space;
  space.grid = gridAbout(box, options.side, options.mostVoxels);
  space.onTable = space.grid.low.z() == 0.0;
  const VoxelGrid& grid = space.grid;
  space.state.assign(grid.size(), VoxelState::Unseen);
  space.level.assign(grid.size(), 0.0F);
  space.pull.assign(grid.size(), 0.0F);
  std::vector<Pose> T_scanner_object;
  for (const View& view : views) T_scanner_object.push_back(view.T_object_scanner.inverse());
  const std::vector<std::uint8_t> near = nearTriangles(model, grid, kNearSurface * grid.side);
  parallelChunks(static_cast<std::size_t>(grid.counts[2]), 1, progress, [&](std::size_t begin, std::size_t /*end*/) {
    const int z = static_cast<int>(begin);
    Carver carver(obstacles, views, T_scanner_object, grid.side, options);
    for (int y = 0; y < grid.counts[1]; ++y)
      for (int x = 0; x < grid.counts[0]; ++x) {
        const std::size_t i = grid.index(x, y, z);
        const Vec3 p = grid.centre(x, y, z);
        const auto level = near[i] != 0 ? levelAt(p, model, obstacles, grid.side) : std::nullopt;
        if (level) {
          space.state[i] = VoxelState::Surface;
          space.level[i] = *level;
        } else if (isOutermost(space, x, y, z) || carver.isFree(p)) {
          space.state[i] = VoxelState::Free;
          space.level[i] = 1.0F;
        } else {
          space.pull[i] = static_cast<float>(options.silence * static_cast<double>(carver.silent()));
        }
      }
  });
  return space;
}

}  // namespace vantage
