#include "forecast/forecast_ledger.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double kMostShare = 2.0;
constexpr double kMostWeight = 300.0;  // [sample spacings squared]
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 1.3;

}  // namespace

ForecastTrust trustIn(std::span<const ForecastEntry> ledger, double spacing, const LedgerOptions& options) {
  const double unit = spacing * spacing;
  double weights = options.priorArea * unit;
  double shares = weights * options.priorFactor;
  double squares = weights * (options.priorFactor * options.priorFactor + options.priorSpread * options.priorSpread);
  std::size_t used = 0;
  for (auto entry = ledger.rbegin(); entry != ledger.rend() && used < options.remembered; ++entry) {
    if (!(entry->predicted > 0.0)) continue;
    const double share = std::clamp(entry->achieved / entry->predicted, 0.0, kMostShare);
    const double weight = std::min(entry->predicted, kMostWeight * unit);
    weights += weight;
    shares += weight * share;
    squares += weight * share * share;
    ++used;
  }
  const double mean = weights > 0.0 ? shares / weights : options.priorFactor;
  const double variance = weights > 0.0 ? squares / weights - mean * mean : options.priorSpread * options.priorSpread;
  return {std::clamp(mean, kLeastFactor, kMostFactor), std::sqrt(std::max(0.0, variance))};
}

}  // namespace vantage
