#include "scanner/thinning.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

// Places that are looked at to tell how far away a scan is.
constexpr std::size_t kLooks = 20'000;

// One side of a grid, thinned.
struct Side {
  int first;
  int count;
};

Side thinnedSide(int count, int step) {
  return {(count - 1) % step / 2, (count - 1) / step + 1};
}

int mostStep(const RayGrid& rays) {
  return std::min(rays.rows(), rays.columns()) - 1;
}

std::size_t raysLeft(const RayGrid& rays, int step) {
  return static_cast<std::size_t>(thinnedSide(rays.rows(), step).count) *
         static_cast<std::size_t>(thinnedSide(rays.columns(), step).count);
}

// Median distance from ray to farthest neighbour at the samples; 0 for an empty image.
double spacingOf(const RangeImage& image) {
  const RayGrid& rays = *image.rays;
  const std::size_t stride = std::max<std::size_t>(1, rays.size() / kLooks);
  std::vector<double> spacings;
  for (std::size_t i = 0; i < rays.size(); i += stride) {
    if (!image.valid(i)) continue;
    const auto columns = static_cast<std::size_t>(rays.columns());
    spacings.push_back(
        rays.spacingAt(image.point(i), {static_cast<double>(i / columns), static_cast<double>(i % columns)}));
  }
  if (spacings.empty()) return 0.0;
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

template <typename Visit>
void forThinned(const RayGrid& rays, int step, const Visit& visit) {
  const Side rows = thinnedSide(rays.rows(), step);
  const Side columns = thinnedSide(rays.columns(), step);
  for (int r = 0; r < rows.count; ++r)
    for (int c = 0; c < columns.count; ++c) visit(rays.index(rows.first + r * step, columns.first + c * step));
}

// Whether a grid is what is left of another.
bool isThinned(const RayGrid& grid, const RayGrid& whole, int step) {
  const std::size_t receivers = whole.receivers(0).size();
  if (grid.rows() != thinnedSide(whole.rows(), step).count ||
      grid.columns() != thinnedSide(whole.columns(), step).count || grid.receivers(0).size() != receivers)
    return false;
  bool same = true;
  std::size_t k = 0;
  forThinned(whole, step, [&](std::size_t i) {
    same = same && grid.ray(k).origin == whole.ray(i).origin && grid.ray(k).direction == whole.ray(i).direction;
    for (std::size_t r = 0; same && r < receivers; ++r) same = grid.receivers(k)[r] == whole.receivers(i)[r];
    ++k;
  });
  return same;
}

}  // namespace

int thinningStep(const RangeImage& image, const ThinningOptions& options) {
  const RayGrid& rays = *image.rays;
  int step = 1;
  if (!options.spacing) {
    if (rays.size() <= kWholeRays) return 1;
    while (step < mostStep(rays) && raysLeft(rays, step) > kUsefulRays) ++step;
    return step;
  }
  const double spacing = *options.spacing > 0.0 ? spacingOf(image) : 0.0;
  if (!(spacing > 0.0)) return 1;
  return static_cast<int>(std::clamp(*options.spacing / spacing, 1.0, static_cast<double>(mostStep(rays))));
}

std::shared_ptr<const RayGrid> thinnedRays(const std::shared_ptr<const RayGrid>& rays, int step,
                                           const std::shared_ptr<const RayGrid>& like) {
  if (step == 1) return rays;
  const RayGrid& whole = *rays;
  if (step < 1 || step > mostStep(whole))
    throw InvalidInput("every " + std::to_string(step) + "-th row and column of " + std::to_string(whole.rows()) +
                       " x " + std::to_string(whole.columns()) + " rays are fewer than 2 x 2");
  if (like && isThinned(*like, whole, step)) return like;
  const std::size_t receivers = whole.receivers(0).size();
  std::vector<RangingRay> some;
  std::vector<Vec3> watching;
  some.reserve(raysLeft(whole, step));
  watching.reserve(receivers * raysLeft(whole, step));
  forThinned(whole, step, [&](std::size_t i) {
    some.push_back(whole.ray(i));
    watching.insert(watching.end(), whole.receivers(i).begin(), whole.receivers(i).end());
  });
  return std::make_shared<const RayGrid>(thinnedSide(whole.rows(), step).count,
                                         thinnedSide(whole.columns(), step).count, std::move(some), std::move(watching),
                                         static_cast<int>(receivers));
}

std::size_t rayBeforeThinning(const RayGrid& whole, int step, std::size_t i) {
  const Side rows = thinnedSide(whole.rows(), step);
  const Side columns = thinnedSide(whole.columns(), step);
  const auto count = static_cast<std::size_t>(columns.count);
  return whole.index(rows.first + static_cast<int>(i / count) * step,
                     columns.first + static_cast<int>(i % count) * step);
}

std::shared_ptr<const RangeImage> thinned(const std::shared_ptr<const RangeImage>& image, int step,
                                          const std::shared_ptr<const RayGrid>& like) {
  if (step == 1) return image;
  auto some = std::make_shared<RangeImage>(*image);
  some->rays = thinnedRays(image->rays, step, like);
  some->range.clear();
  some->colours.clear();
  some->range.reserve(some->rays->size());
  forThinned(*image->rays, step, [&](std::size_t i) { some->range.push_back(image->range[i]); });
  if (!image->colours.empty())
    forThinned(*image->rays, step, [&](std::size_t i) { some->colours.push_back(image->colours[i]); });
  some->range.shrink_to_fit();
  some->colours.shrink_to_fit();
  return some;
}

}  // namespace vantage
