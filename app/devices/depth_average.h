#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vantage {

/// Depths of a camera's pixels, row by row, in counts of its own; 0 where it measured nothing.
using DepthFrame = std::vector<std::uint16_t>;

struct DepthAverageOptions {
  /// A pixel that measured in a smaller share of the frames has no depth, 0..1.
  double leastShare = 0.34;
  /// Depths farther than so many standard deviations from the median of the frames do not count; the deviation is that
  /// which the median of the distances tells.
  double outlierSigmas = 3.0;
  /// Depths up to so many counts from the median always count: a depth is a whole number.
  double always = 1.0;
};

/// Per pixel the median of what the frames measured, and then the mean of those near it, in counts; 0 where too few
/// measured. @throws InvalidInput when there is no frame or they differ in size
[[nodiscard]] std::vector<float> averageDepth(const std::vector<DepthFrame>& frames,
                                              const DepthAverageOptions& options = {});

}  // namespace vantage
