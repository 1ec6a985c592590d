#include "devices/depth_average.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kSigmaOfMedian = 1.4826;

// Of sorted values, between the middle two where they are even in number.
double medianOfSorted(const std::vector<double>& values) {
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double median(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  return medianOfSorted(values);
}

// The depths of the pixels that measured often enough, each sorted; empty of others.
std::vector<std::vector<double>> measuredDepths(const std::vector<DepthFrame>& frames, double leastShare) {
  const double least = std::max(1.0, leastShare * static_cast<double>(frames.size()));
  std::vector<std::vector<double>> measured(frames.front().size());
  for (std::size_t i = 0; i < measured.size(); ++i) {
    for (const DepthFrame& frame : frames)
      if (frame[i] != 0) measured[i].push_back(frame[i]);
    if (static_cast<double>(measured[i].size()) < least) measured[i].clear();
    std::sort(measured[i].begin(), measured[i].end());
  }
  return measured;
}

// Standard deviation of a depth over its square: the median of what every pixel tells.
double relativeNoise(const std::vector<std::vector<double>>& measured) {
  std::vector<double> noise;
  std::vector<double> distances;
  for (const std::vector<double>& depths : measured) {
    if (depths.empty()) continue;
    const double middle = medianOfSorted(depths);
    distances.clear();
    for (const double depth : depths) distances.push_back(std::abs(depth - middle));
    noise.push_back(kSigmaOfMedian * median(distances) / (middle * middle));
  }
  return noise.empty() ? 0.0 : median(noise);
}

// The mean of the shortest interval that half of the depths lie in. @pre sorted and not empty
double densest(const std::vector<double>& depths) {
  const std::size_t half = (depths.size() + 1) / 2;
  std::size_t best = 0;
  for (std::size_t i = 1; i + half <= depths.size(); ++i)
    if (depths[i + half - 1] - depths[i] < depths[best + half - 1] - depths[best]) best = i;
  const auto begin = depths.begin() + static_cast<std::ptrdiff_t>(best);
  return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(half), 0.0) / static_cast<double>(half);
}

// The mean of what agrees; 0 when that is not more than half.
double agreed(const std::vector<double>& depths, double noise, const DepthAverageOptions& options) {
  const double middle = densest(depths);
  const double reach = std::max(options.always, options.outlierSigmas * noise * middle * middle);
  double sum = 0.0;
  double count = 0.0;
  for (const double depth : depths) {
    if (std::abs(depth - middle) > reach) continue;
    sum += depth;
    count += 1.0;
  }
  return 2.0 * count > static_cast<double>(depths.size()) ? sum / count : 0.0;
}

}  // namespace

std::vector<float> averageDepth(const std::vector<DepthFrame>& frames, const DepthAverageOptions& options) {
  if (frames.empty()) throw InvalidInput("no depth frames to average: expected at least one");
  for (const DepthFrame& frame : frames)
    if (frame.size() != frames.front().size())
      throw InvalidInput("depth frames of " + std::to_string(frames.front().size()) + " and of " +
                         std::to_string(frame.size()) + " pixels cannot be averaged");
  const std::vector<std::vector<double>> measured = measuredDepths(frames, options.leastShare);
  const double noise = relativeNoise(measured);
  std::vector<float> average(measured.size(), 0.0F);
  for (std::size_t i = 0; i < average.size(); ++i)
    if (!measured[i].empty()) average[i] = static_cast<float>(agreed(measured[i], noise, options));
  return average;
}

}  // namespace vantage
