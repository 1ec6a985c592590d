#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "planning/patch_outlook.h"
#include "planning/planning_scene.h"

namespace vantage {

/// What is known of every patch of the scene. With `positions` (T_table_scanner of all of the workspace, once nothing
/// attracts a view strongly any more) it is the certificate of termination: why each edge is left, and what a view
/// could still show of it; without them reasons stay BelowThreshold unless answered.
/// @throws Cancelled
[[nodiscard]] std::vector<PatchOutlook> certify(const PlanningScene& scene, std::span<const Pose> positions,
                                                const Progress& progress);

/// What all views that are still possible together could show: every patch from the position that shows most [mm^2].
[[nodiscard]] double promiseLeft(std::span<const PatchOutlook> outlook);

}  // namespace vantage
