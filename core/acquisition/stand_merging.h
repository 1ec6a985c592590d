#pragma once

#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"

namespace vantage {

/// The state after it became known how the object stands in a stand: the views of its composite become views of the
/// object, all of which are refined together and make one model. Then the scans of the stand that were waiting or did
/// not fit its composite are registered in their order. Steps reported: register, integrate.
/// @param poses T_object_scanner of the views of the object, then of those of the stand, as they were refined by an
/// aligner; none: they are refined here, with what the mechanics say inside of every stand
/// @pre the stand is not known yet @throws Cancelled
[[nodiscard]] AcquisitionState mergedStand(const AcquisitionState& state, int stand, const Pose& T_object_table,
                                           const std::vector<Pose>& poses, const StepOptions& options,
                                           const Progress& progress);

}  // namespace vantage
