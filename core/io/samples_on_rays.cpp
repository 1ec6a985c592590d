#include "io/samples_on_rays.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vantage {
namespace {

constexpr std::size_t kPerCheckpoint = 8192;
// Points on one ray within so many spacings of the first are of the same surface.
constexpr double kSameSurface = 3.0;
// Farther beside its ray [cells] a point says more with its neighbours than alone.
constexpr double kBeside = 0.02;
constexpr double kSteepest = 6.0;  // change of range from ray to ray [spacings]

// A point with its place among the rays.
struct Placed {
  std::uint32_t point = 0;
  std::uint32_t ray = 0;
  float range = 0.0F;
  float row = 0.0F;     // beside its ray [cells]
  float column = 0.0F;  // likewise
  float spacing = 0.0F;

  [[nodiscard]] float beside() const { return std::max(std::abs(row), std::abs(column)); }
};

class Placement {
 public:
  Placement(const std::vector<Vec3>& points, const std::shared_ptr<const RayGrid>& rays)
      : points_(points), rays_(rays) {}

  SamplesOnRays place(const std::vector<Colour>& colours, const Progress& progress) {
    locate(progress);
    choose();
    SamplesOnRays result;
    result.outside = points_.size() - placed_.size();
    result.hidden = hidden_;
    result.image.rays = rays_;
    result.image.range.assign(rays_->size(), kNoSample);
    if (!colours.empty()) result.image.colours.assign(rays_->size(), Colour{});
    for (std::size_t i = 0; i < rays_->size(); ++i) {
      if (chosen_[i] == nullptr) continue;
      result.image.range[i] = static_cast<float>(std::max(0.0, rangeAt(i)));
      if (!colours.empty()) result.image.colours[i] = colours[chosen_[i]->point];
    }
    return result;
  }

 private:
  void locate(const Progress& progress) {
    GridPosition hint{0.5 * (rays_->rows() - 1), 0.5 * (rays_->columns() - 1)};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i % kPerCheckpoint == 0) progress.checkpoint(static_cast<double>(i) / static_cast<double>(points_.size()));
      const auto place = rays_->locate(points_[i], hint);
      if (!place) continue;
      hint = *place;
      const std::size_t nearest = rays_->nearest(*place);
      const RangingRay& ray = rays_->ray(nearest);
      const double range = (points_[i] - ray.origin).dot(ray.direction);
      if (!(range > 0.0)) continue;
      const auto row = static_cast<double>(nearest / static_cast<std::size_t>(rays_->columns()));
      const auto column = static_cast<double>(nearest % static_cast<std::size_t>(rays_->columns()));
      placed_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(nearest), static_cast<float>(range),
                         static_cast<float>(place->row - row), static_cast<float>(place->column - column),
                         static_cast<float>(rays_->spacingAt(points_[i], *place))});
    }
  }

  void choose() {
    std::vector<float> front(rays_->size(), std::numeric_limits<float>::infinity());
    for (const Placed& p : placed_) front[p.ray] = std::min(front[p.ray], p.range);
    chosen_.assign(rays_->size(), nullptr);
    for (const Placed& p : placed_) {
      if (p.range > front[p.ray] + static_cast<float>(kSameSurface) * p.spacing) {
        ++hidden_;
        continue;
      }
      const Placed*& chosen = chosen_[p.ray];
      if (chosen == nullptr || p.beside() < chosen->beside()) chosen = &p;
    }
  }

  // The range where the ray itself meets the surface that neighbouring points are on.
  [[nodiscard]] double rangeAt(std::size_t i) const {
    const Placed& own = *chosen_[i];
    const auto range = static_cast<double>(own.range);
    if (static_cast<double>(own.beside()) <= kBeside) return range;
    const int row = static_cast<int>(i) / rays_->columns();
    const int column = static_cast<int>(i) % rays_->columns();
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    Vec2 b = Vec2::Zero();
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rays_->rows() - 1); ++r) {
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, rays_->columns() - 1); ++c) {
        const Placed* other = chosen_[rays_->index(r, c)];
        if (other == nullptr || other == &own) continue;
        const double change = static_cast<double>(other->range) - range;
        if (std::abs(change) > kSteepest * static_cast<double>(own.spacing)) continue;
        const Vec2 step(r - row + static_cast<double>(other->row - own.row),
                        c - column + static_cast<double>(other->column - own.column));
        a += step * step.transpose();
        b += change * step;
      }
    }
    if (!(a.determinant() > 1e-3)) return range;
    const Vec2 slope = a.inverse() * b;
    return range - slope.x() * static_cast<double>(own.row) - slope.y() * static_cast<double>(own.column);
  }

  const std::vector<Vec3>& points_;
  const std::shared_ptr<const RayGrid>& rays_;
  std::vector<Placed> placed_;
  std::vector<const Placed*> chosen_;
  std::size_t hidden_ = 0;
};

}  // namespace

SamplesOnRays samplesOnRays(const std::vector<Vec3>& points, const std::vector<Colour>& colours,
                            const std::shared_ptr<const RayGrid>& rays, const Progress& progress) {
  return Placement(points, rays).place(colours, progress);
}

}  // namespace vantage
