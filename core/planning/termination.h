#pragma once

#include <optional>

namespace vantage {

struct TerminationOptions {
  /// F [mm^2]; unset: what `edges` boundary edges of one sample spacing show that are seen head-on, but no less than
  /// `share` of the model's area.
  std::optional<double> threshold;
  double edges = 17.0;
  double share = 0.0005;
};

/// F: what a view must promise to be worth taking (Pito 1999, 5.3) [mm^2].
/// @param spacing of the samples [mm]
/// @param modelArea [mm^2]
[[nodiscard]] double terminationThreshold(const TerminationOptions& options, double spacing, double modelArea);

}  // namespace vantage
