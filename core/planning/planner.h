#pragma once

#include "base/progress.h"
#include "planning/plan.h"
#include "planning/planner_options.h"
#include "planning/planning_scene.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// Finds the next best view (Pito 1999, 5.3): void patches on the model's boundary and the model's triangles are
/// projected into positional space, every position of the workspace is scored by intersecting its image with theirs,
/// and the positions that promise most are judged again with the scanner's own rays. A position that was taken in this
/// stand promises nothing. The void patches of the plan are in the object's frame. Steps reported: void_patches,
/// project_void, project_seen, choose.
/// @param images of the input's profile
/// @throws InvalidInput when there is no view yet. @throws Cancelled
[[nodiscard]] Plan planNextView(const PlanInput& input, const ScannerImages& images, const PlannerOptions& options,
                                const Progress& progress);

}  // namespace vantage
