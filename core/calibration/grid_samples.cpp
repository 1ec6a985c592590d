#include "calibration/grid_samples.h"

#include <algorithm>
#include <cmath>

namespace vantage {

std::vector<GridSample> gridSamples(std::span<const RangeImage> scans, std::size_t count) {
  std::size_t all = 0;
  for (const RangeImage& scan : scans) all += scan.sampleCount();
  const std::size_t step = all / std::max<std::size_t>(count, 1) + 1;
  std::vector<GridSample> samples;
  std::size_t k = 0;
  for (const RangeImage& scan : scans) {
    const auto columns = static_cast<std::size_t>(scan.rays->columns());
    for (std::size_t i = 0; i < scan.range.size(); ++i) {
      if (!scan.valid(i) || k++ % step != 0) continue;
      samples.push_back({static_cast<double>(i / columns), static_cast<double>(i % columns), scan.point(i)});
    }
  }
  return samples;
}

double distanceFromRays(std::span<const GridSample> samples, const RayGrid& rays) {
  std::vector<double> squares;
  for (const GridSample& sample : samples) {
    const RangingRay& ray = rays.ray(rays.nearest({sample.row, sample.column}));
    squares.push_back((sample.point - ray.origin).cross(ray.direction).squaredNorm());
  }
  std::sort(squares.begin(), squares.end());
  squares.resize(squares.size() - squares.size() / 10);
  double sum = 0.0;
  for (const double square : squares) sum += square;
  return squares.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(squares.size()));
}

}  // namespace vantage
