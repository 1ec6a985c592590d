#include "planning/termination.h"

#include <algorithm>

namespace vantage {

double terminationThreshold(const TerminationOptions& options, double spacing, double modelArea) {
  return options.threshold.value_or(std::max(options.edges * spacing * spacing, options.share * modelArea));
}

}  // namespace vantage
