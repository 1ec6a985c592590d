#pragma once

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"

namespace vantage {

/// A scan that fits the model may still contradict what the views have looked through, or show emptiness where they saw
/// surface: then its registration becomes a failure. What is known is held against the views whose
/// place is known only.
/// @param scan registered with the model, where its registration found it
/// @throws Cancelled
void checkAgainstOthers(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                        const Progress& progress);

}  // namespace vantage
