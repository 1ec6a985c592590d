#pragma once

#include <span>
#include <vector>

#include "scanner/range_image.h"

namespace vantage {

/// A sample and its place in the grid of its scanner.
struct GridSample {
  double row = 0.0;
  double column = 0.0;
  Vec3 point = Vec3::Zero();  ///< [mm]
};

/// About `count` samples of scans of one grid, spread evenly.
[[nodiscard]] std::vector<GridSample> gridSamples(std::span<const RangeImage> scans, std::size_t count);

/// Root mean square distance of samples from the rays of their cells [mm]; of the nine tenths that lie best, as some
/// fly.
[[nodiscard]] double distanceFromRays(std::span<const GridSample> samples, const RayGrid& rays);

}  // namespace vantage
