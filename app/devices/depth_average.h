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
  /// Depths of a pixel agree up to so many standard deviations of the camera's noise.
  double outlierSigmas = 3.0;
  /// Depths always agree up to so many counts: a depth is a whole number.
  double always = 1.0;
};

/// Per pixel the mean of the depths that agree, in counts; 0 where too few measured, or where no more than half of what
/// was measured agrees: at an edge, where depths jump between front and back from frame to frame.
///
/// What agrees is near the middle of the shortest interval that half of the depths lie in. The noise grows with the
/// square of the depth; how large it is, the pixels tell in their median.
/// @throws InvalidInput when there is no frame or they differ in size
[[nodiscard]] std::vector<float> averageDepth(const std::vector<DepthFrame>& frames,
                                              const DepthAverageOptions& options = {});

}  // namespace vantage
