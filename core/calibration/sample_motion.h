#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scanner/range_image.h"

namespace vantage {

/// A scan from a scanner that stays before a table that turns.
struct CalibrationScan {
  std::shared_ptr<const RangeImage> image;  ///< its pose is not used
  double tableAngle = 0.0;                  ///< where the table stood, as it counts [deg]
};

/// What a sample is seen to be on.
enum class SampleMotion : std::uint8_t {
  None,    ///< nothing was measured
  Still,   ///< is at the same place in the other scans: table top, background, a surface of revolution about the axis
  Moving,  ///< on what turns
};

/// The motion of every sample of every scan, by the ranges that the same ray has in the other scans: still is what most
/// of those have in common that are not hidden there. Differences up to six sigmas of the noise count as none.
/// @throws InvalidInput when the scans are not of one grid of rays
[[nodiscard]] std::vector<std::vector<SampleMotion>> sampleMotions(std::span<const CalibrationScan> scans);

/// Noise of the ranges of a scan along its rays [mm], by how ranges scatter about those of their neighbours, which is
/// the noise on even surfaces: a function of the range, in steps of equally many samples.
class RangeNoiseCurve {
 public:
  explicit RangeNoiseCurve(const RangeImage& image);
  [[nodiscard]] double at(double range) const;
  /// Over all ranges.
  [[nodiscard]] double median() const { return median_; }

 private:
  struct Step {
    double upTo;  // [mm]
    double sigma;
  };
  std::vector<Step> steps_;
  double median_ = 0.0;
};

}  // namespace vantage
