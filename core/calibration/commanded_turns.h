#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vantage {

/// How a table turned against how it counted.
struct CommandedTurns {
  int sense = 1;       ///< 1: it counts upwards when it turns counter-clockwise about the axis
  double ratio = 1.0;  ///< degrees that it turns per degree that it counts, positive
  double ratioSigma = 0.0;
  std::vector<double> off;  ///< per scan, how far it stood from where it counted to be [rad], 0 in the first
  double spread = 0.0;      ///< of those, slips aside: one sigma [rad]
  /// The first scan before which the table slipped, or was knocked.
  std::optional<std::size_t> slippedBefore;
  double slip = 0.0;  ///< of the largest slip [rad]
};

/// Ratio and sense by least squares over the turns between scans that follow each other in time; a turn that is off by
/// more than a degree and four sigmas of the usual table against the median of all is a slip, after which the table
/// stands elsewhere. A ratio that is 1 within three sigmas is 1.
/// @param tableAngles one per scan, in the order in which they were taken [deg]
/// @param angles as they were found, counter-clockwise about the axis [rad]
/// @pre two different table angles
[[nodiscard]] CommandedTurns explainTurns(std::span<const double> tableAngles, std::span<const double> angles);

}  // namespace vantage
