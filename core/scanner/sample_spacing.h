#pragma once

#include <algorithm>
#include <cstddef>

#include "scanner/range_image.h"

namespace vantage {

/// Distance of two rays of a grid where the nearer of their samples lies, across the first [mm]. @pre both are valid
[[nodiscard]] inline double raySpacing(const RangeImage& image, std::size_t a, std::size_t b) {
  const auto depth = static_cast<double>(std::min(image.range[a], image.range[b]));
  const RangingRay& first = image.rays->ray(std::min(a, b));
  const RangingRay& second = image.rays->ray(std::max(a, b));
  const Vec3 offset = (second.origin - first.origin) + depth * (second.direction - first.direction);
  return (offset - offset.dot(first.direction) * first.direction).norm();
}

}  // namespace vantage
