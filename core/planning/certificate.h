#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "planning/patch_outlook.h"
#include "planning/plan.h"
#include "planning/visibility.h"

namespace vantage {

/// What is known of every patch. With `positions` (all of the workspace, once nothing attracts a view strongly any
/// more) it is the certificate of termination: why each edge is left, and what a view could still show of it; without
/// them reasons stay BelowThreshold unless answered.
/// @param breakdownAngle for the look-ahead [rad]; unset: without it.
[[nodiscard]] std::vector<PatchOutlook> certify(std::span<const VoidPatch> patches, const PatchHistory& history,
                                                std::span<const Pose> positions, const SightTest& sight,
                                                std::optional<double> breakdownAngle, const Progress& progress);

/// What all views that are still possible together could show: every patch from the position that shows most [mm^2].
[[nodiscard]] double promiseLeft(std::span<const PatchOutlook> outlook);

}  // namespace vantage
