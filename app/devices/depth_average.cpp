#include "devices/depth_average.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

// Of sorted values, between the middle two where they are even in number.
double medianOfSorted(const std::vector<double>& values) {
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double robustMean(std::vector<double>& depths, std::vector<double>& distances, const DepthAverageOptions& options) {
  std::sort(depths.begin(), depths.end());
  const double median = medianOfSorted(depths);
  distances.clear();
  for (const double depth : depths) distances.push_back(std::abs(depth - median));
  std::sort(distances.begin(), distances.end());
  constexpr double kSigmaOfMedian = 1.4826;
  const double reach = std::max(options.always, options.outlierSigmas * kSigmaOfMedian * medianOfSorted(distances));
  double sum = 0.0;
  double count = 0.0;
  for (const double depth : depths) {
    if (std::abs(depth - median) > reach) continue;
    sum += depth;
    count += 1.0;
  }
  // Two groups of which none is near the middle.
  return count > 0.0 ? sum / count : median;
}

}  // namespace

std::vector<float> averageDepth(const std::vector<DepthFrame>& frames, const DepthAverageOptions& options) {
  if (frames.empty()) throw InvalidInput("no depth frames to average: expected at least one");
  for (const DepthFrame& frame : frames)
    if (frame.size() != frames.front().size())
      throw InvalidInput("depth frames of " + std::to_string(frames.front().size()) + " and of " +
                         std::to_string(frame.size()) + " pixels cannot be averaged");
  const double least = std::max(1.0, options.leastShare * static_cast<double>(frames.size()));
  std::vector<float> average(frames.front().size(), 0.0F);
  std::vector<double> depths;
  std::vector<double> distances;
  for (std::size_t i = 0; i < average.size(); ++i) {
    depths.clear();
    for (const DepthFrame& frame : frames)
      if (frame[i] != 0) depths.push_back(frame[i]);
    if (static_cast<double>(depths.size()) < least) continue;
    average[i] = static_cast<float>(robustMean(depths, distances, options));
  }
  return average;
}

}  // namespace vantage
