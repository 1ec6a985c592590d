#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "scanner/range_image.h"

namespace vantage {

/// Up to which angle between surface and ray a scanner has samples.
struct SampleEnd {
  double angle = 0.0;  ///< the likely one [rad]
  double from = 0.0;   ///< it is not below this [rad]
  double to = 0.0;     ///< nor above this, as far as the scans tell [rad]
};

/// The end of incidence angles [rad], one per piece of surface that a scanner sampled evenly over its rays. Surface
/// that leans all ways gives numbers in proportion to sin cos of the angle; the end is where they fall to half of that.
/// Flat things pile up at their angles and do not count; where nothing leans all ways most angles end before the end.
/// @pre there are angles
[[nodiscard]] SampleEnd sampleEnd(std::span<const double> angles);

/// The incidence angles of the samples of scans, up to 85 degrees [rad]. @throws Cancelled
[[nodiscard]] std::vector<double> incidenceAngles(std::span<const RangeImage> scans, const Progress& progress);

}  // namespace vantage
