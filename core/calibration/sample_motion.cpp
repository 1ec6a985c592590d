#include "calibration/sample_motion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr std::size_t kSteps = 8;
constexpr double kSigmas = 6.0;
// Below the resolution of any range file nothing is called a motion [mm].
constexpr double kLeastDifference = 0.02;
// Of the scans that do not hide a still sample so many see it.
constexpr double kShare = 0.75;
constexpr std::size_t kFewest = 2;

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Range and absolute second difference along the row, where there is one.
std::vector<std::pair<double, double>> secondDifferences(const RangeImage& image) {
  std::vector<std::pair<double, double>> result;
  const RayGrid& rays = *image.rays;
  for (int row = 0; row < rays.rows(); ++row) {
    for (int column = 1; column + 1 < rays.columns(); ++column) {
      const std::size_t i = rays.index(row, column);
      if (!image.valid(i - 1) || !image.valid(i) || !image.valid(i + 1)) continue;
      const double range = static_cast<double>(image.range[i]);
      const double bend =
          static_cast<double>(image.range[i - 1]) - 2.0 * range + static_cast<double>(image.range[i + 1]);
      result.emplace_back(range, std::abs(bend));
    }
  }
  return result;
}

// 1.4826 makes a sigma of a median; a second difference of independent numbers has sqrt 6 times their sigma.
double sigmaOf(double medianBend) {
  return 1.4826 * medianBend / std::sqrt(6.0);
}

bool isStill(std::span<const CalibrationScan> scans, std::size_t scan, std::size_t ray, double tolerance) {
  const double range = static_cast<double>(scans[scan].image->range[ray]);
  std::size_t same = 0;
  std::size_t gone = 0;
  for (std::size_t other = 0; other < scans.size(); ++other) {
    if (other == scan || !scans[other].image->valid(ray)) continue;
    const double difference = static_cast<double>(scans[other].image->range[ray]) - range;
    if (std::abs(difference) <= tolerance) {
      ++same;
    } else if (difference > 0.0) {
      ++gone;
    }
  }
  return same >= kFewest && static_cast<double>(same) >= kShare * static_cast<double>(same + gone);
}

}  // namespace

RangeNoiseCurve::RangeNoiseCurve(const RangeImage& image) {
  auto bends = secondDifferences(image);
  std::sort(bends.begin(), bends.end());
  std::vector<double> all;
  for (std::size_t step = 0; step < kSteps && !bends.empty(); ++step) {
    const std::size_t begin = bends.size() * step / kSteps;
    const std::size_t end = bends.size() * (step + 1) / kSteps;
    std::vector<double> values;
    for (std::size_t k = begin; k < end; ++k) values.push_back(bends[k].second);
    if (values.empty()) continue;
    all.insert(all.end(), values.begin(), values.end());
    steps_.push_back({bends[end - 1].first, sigmaOf(medianOf(std::move(values)))});
  }
  median_ = sigmaOf(medianOf(std::move(all)));
}

double RangeNoiseCurve::at(double range) const {
  for (const Step& step : steps_)
    if (range <= step.upTo) return step.sigma;
  return steps_.empty() ? 0.0 : steps_.back().sigma;
}

std::vector<std::vector<SampleMotion>> sampleMotions(std::span<const CalibrationScan> scans) {
  std::vector<std::vector<SampleMotion>> motions;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const RangeImage& image = *scans[k].image;
    const RayGrid& first = *scans.front().image->rays;
    if (image.rays->rows() != first.rows() || image.rays->columns() != first.columns())
      throw InvalidInput("scan " + std::to_string(k) + " has " + std::to_string(image.rays->rows()) + " x " +
                         std::to_string(image.rays->columns()) + " rays, expected the " + std::to_string(first.rows()) +
                         " x " + std::to_string(first.columns()) + " of the first: all scans of one scanner");
    const RangeNoiseCurve noise(image);
    std::vector<SampleMotion> motion(image.range.size(), SampleMotion::None);
    for (std::size_t i = 0; i < motion.size(); ++i) {
      if (!image.valid(i)) continue;
      const double tolerance = kLeastDifference + kSigmas * noise.at(static_cast<double>(image.range[i]));
      motion[i] = isStill(scans, k, i, tolerance) ? SampleMotion::Still : SampleMotion::Moving;
    }
    motions.push_back(std::move(motion));
  }
  return motions;
}

}  // namespace vantage
