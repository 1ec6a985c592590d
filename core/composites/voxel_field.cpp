#include "composites/voxel_field.h"

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/mesh.h"

namespace vantage {
namespace {

// A ray has passed through the cubes that lie at least this far before its sample [cubes].
constexpr double kBefore = 1.5;
// What is nearer to the surface is not free, however many rays passed [cubes].
constexpr double kOffSurface = 1.2;
constexpr std::uint8_t kFewestRays = 2;
// Samples whose rays are followed, of all views together.
constexpr std::size_t kMostRays = 300'000;
constexpr int kSweeps = 2;

}  // namespace

VoxelField::VoxelField(std::span<const Vec3> points, std::span<const View> views, double side, double margin,
                       const Progress& progress)
    : side_(side) {
  BoundingBox box{points.front(), points.front()};
  for (const Vec3& p : points) box.extend(p);
  origin_ = box.min - Vec3::Constant(margin);
  for (int axis = 0; axis < 3; ++axis)
    counts_[static_cast<std::size_t>(axis)] = static_cast<int>((box.size()[axis] + 2.0 * margin) / side) + 1;
  const std::size_t cubes = static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2];
  nearest_.assign(cubes, kNoIndex);
  free_.assign(cubes, 0);
  countRays(views, progress.part(0.0, 0.4));
  findNearest(points, progress.part(0.4, 1.0));
}

void VoxelField::findNearest(std::span<const Vec3> points, const Progress& progress) {
  std::vector<float> distance(nearest_.size(), std::numeric_limits<float>::infinity());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 place = (points[i] - origin_) / side_;
    const auto x = static_cast<int>(place.x());
    const auto y = static_cast<int>(place.y());
    const auto z = static_cast<int>(place.z());
    const auto d = static_cast<float>((middle(x, y, z) - points[i]).squaredNorm());
    const std::size_t cube = index(x, y, z);
    if (d >= distance[cube]) continue;
    distance[cube] = d;
    nearest_[cube] = i;
  }
  for (int k = 0; k < 2 * kSweeps; ++k)
    sweep(points, k % 2 == 0, distance, progress.part(0.25 * k * 2 / kSweeps, 0.25 * (k + 1) * 2 / kSweeps));
  const auto off = static_cast<float>(kOffSurface * kOffSurface * side_ * side_);
  for (std::size_t cube = 0; cube < free_.size(); ++cube)
    free_[cube] = free_[cube] >= kFewestRays && distance[cube] > off ? 1 : 0;
}

// Hands nearest points on from neighbour to neighbour, from one corner of the field to the other.
void VoxelField::sweep(std::span<const Vec3> points, bool forward, std::vector<float>& distance,
                       const Progress& progress) {
  const auto hand = [&](std::size_t cube, const Vec3& centre, int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= counts_[0] || y >= counts_[1] || z >= counts_[2]) return;
    const std::uint32_t point = nearest_[index(x, y, z)];
    if (point == kNoIndex || point == nearest_[cube]) return;
    const auto d = static_cast<float>((centre - points[point]).squaredNorm());
    if (d > distance[cube] || (d == distance[cube] && point > nearest_[cube])) return;
    distance[cube] = d;
    nearest_[cube] = point;
  };
  const int s = forward ? -1 : 1;
  for (int k = 0; k < counts_[2]; ++k) {
    progress.checkpoint(static_cast<double>(k) / counts_[2]);
    const int z = forward ? k : counts_[2] - 1 - k;
    for (int j = 0; j < counts_[1]; ++j) {
      const int y = forward ? j : counts_[1] - 1 - j;
      for (int i = 0; i < counts_[0]; ++i) {
        const int x = forward ? i : counts_[0] - 1 - i;
        const std::size_t cube = index(x, y, z);
        const Vec3 centre = middle(x, y, z);
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) hand(cube, centre, x + dx, y + dy, z + s);
        for (int dx = -1; dx <= 1; ++dx) hand(cube, centre, x + dx, y + s, z);
        hand(cube, centre, x + s, y, z);
      }
      for (int i = counts_[0] - 2; i >= 0; --i) {
        const int x = forward ? i : counts_[0] - 1 - i;
        hand(index(x, y, z), middle(x, y, z), x - s, y, z);
      }
    }
  }
}

void VoxelField::countRays(std::span<const View> views, const Progress& progress) {
  std::size_t samples = 0;
  for (const View& view : views) samples += view.mesh->sample.size();
  const std::size_t every = samples / kMostRays + 1;
  for (std::size_t v = 0; v < views.size(); ++v) {
    progress.checkpoint(static_cast<double>(v) / static_cast<double>(views.size()));
    const View& view = views[v];
    for (std::size_t k = 0; k < view.mesh->sample.size(); k += every) {
      const std::uint32_t sample = view.mesh->sample[k];
      const RangingRay& ray = view.image->rays->ray(sample);
      countRay(view.T_object_scanner * ray.origin, view.T_object_scanner.linear() * ray.direction,
               view.image->range[sample]);
    }
  }
}

void VoxelField::countRay(const Vec3& origin, const Vec3& direction, double range) {
  std::optional<std::size_t> last;
  bool entered = false;
  for (double along = range - kBefore * side_; along > 0.0; along -= side_) {
    const auto cube = cubeOf(origin + along * direction);
    if (!cube && entered) return;
    if (!cube || cube == last) continue;
    entered = true;
    last = cube;
    if (free_[*cube] < 255) ++free_[*cube];
  }
}

}  // namespace vantage
