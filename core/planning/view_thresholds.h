#pragma once

#include <optional>

namespace vantage {

struct TerminationOptions {
  /// F [mm^2]; unset: what `edges` boundary edges of one sample spacing show that are seen head-on, but no less than
  /// `share` of the model's area.
  std::optional<double> threshold;
  double edges = 15.0;
  double share = 0.0005;
  /// While more is left to see than this share of the model's area, views that show less, down to what so many edges
  /// show (and the same part of `share`), are worth taking, too.
  double leftShare = 0.004;
  double leastEdges = 12.0;
};

/// What a view must promise to be worth taking [mm^2].
struct ViewThresholds {
  double usual = 0.0;  ///< F
  double least = 0.0;  ///< F while more than `left` is left to see
  double left = 0.0;
};

/// @param spacing of the samples [mm]
/// @param modelArea [mm^2]
[[nodiscard]] ViewThresholds viewThresholds(const TerminationOptions& options, double spacing, double modelArea);

}  // namespace vantage
