#pragma once

#include <cstddef>
#include <span>

namespace vantage {

/// What was forecast of a view, and what it showed.
struct ForecastEntry {
  double predicted = 0.0;  ///< new surface, as it was forecast without a correction [mm^2]
  double achieved = 0.0;   ///< new surface [mm^2]
};

struct LedgerOptions {
  std::size_t remembered = 4;  ///< views that count, the last ones: the surface that is left is like theirs
  double priorArea = 60.0;     ///< as much counts what is known beforehand [sample spacings squared] ...
  double priorFactor = 0.7;    ///< ... namely that so much of what was forecast is found
  double priorSpread = 0.5;    ///< and that the share is off by this
};

/// How far forecasts are to be trusted.
struct ForecastTrust {
  double factor = 1.0;  ///< what is found of a forecast, as a share: from 0.2 to 1.3
  double spread = 0.0;  ///< standard deviation of that share
};

/// Learns from the views of a run what its forecasts are worth: the mean share that the last views found, by the area
/// that was forecast, about what is known beforehand. For this, views found no more than twice their forecast, and none
/// was forecast to show more than 300 sample spacings squared.
/// @param ledger in the order of the views; entries that forecast nothing say nothing
/// @param spacing of the samples [mm]
[[nodiscard]] ForecastTrust trustIn(std::span<const ForecastEntry> ledger, double spacing,
                                    const LedgerOptions& options);

}  // namespace vantage
