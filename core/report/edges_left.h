#pragma once

#include <cstddef>
#include <vector>

#include "planning/plan.h"

namespace vantage {

/// Boundary edges of the model that are left for one reason.
struct EdgesLeft {
  EdgeReason reason = EdgeReason::BelowThreshold;
  std::size_t edges = 0;
  double length = 0.0;  ///< [mm]
};

/// What a plan leaves of the model's boundary, by reason in the order of EdgeReason; reasons without edges are left
/// out. Nothing when the plan does not hold its void patches, one outlook each.
[[nodiscard]] std::vector<EdgesLeft> edgesLeft(const Plan& plan);

}  // namespace vantage
