#include "planning/view_thresholds.h"

#include <algorithm>

namespace vantage {

ViewThresholds viewThresholds(const TerminationOptions& options, double spacing, double modelArea) {
  const auto thresholdFor = [&](double edges) {
    const double share = options.share * edges / options.edges;
    return options.threshold.value_or(std::max(edges * spacing * spacing, share * modelArea));
  };
  return {thresholdFor(options.edges), thresholdFor(options.leastEdges), options.leftShare * modelArea};
}

}  // namespace vantage
