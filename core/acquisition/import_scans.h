#pragma once

#include <optional>
#include <string>
#include <vector>

#include "acquisition/step_options.h"
#include "acquisition/steps.h"
#include "base/progress.h"
#include "integration/zipper.h"
#include "registration/alignment.h"
#include "registration/pose_list.h"
#include "void_space/void_patch_builder.h"

namespace vantage {

/// The state with recorded scans in it: registered from the poses that they came with, the first of which stays if
/// it is of the set that hangs together (see registerViews), and zippered; those that did not find their place are
/// rejected. It has ended, as nothing is planned from recorded scans.
/// Steps reported: register, integrate.
/// @throws InvalidInput when there is no scan or the first has no surface; Cancelled
[[nodiscard]] AcquisitionState importScans(const AcquisitionState& state, const std::vector<NumberedScan>& scans,
                                           const ImportOptions& options, const Progress& progress);

/// What the poses that scans came with have wrong in common, going by where their views were found: nothing where no
/// such fault explains most of it, or where it moves no view by more than two spacings.
[[nodiscard]] std::optional<PoseListFinding> poseListFault(const AcquisitionState& state);

}  // namespace vantage
