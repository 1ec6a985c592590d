#pragma once

#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "registration/multi_view.h"
#include "registration/view_network.h"

namespace vantage {

/// Whether later scans may settle a doubt: nothing spoke against the pose, and not enough for it.
[[nodiscard]] bool waitsForMore(const RegistrationResult& registration);

/// Views that a person turned fit only together with doubtful ones as long as they are a chain; once it closes, an
/// error of one link would show. Those that closed loops of views hold to known ones become good, where the refinement
/// holds them as firmly as a good view is certain. Where more views hold each other than are known so far, they are
/// what is known, and what was becomes doubtful until something holds it to them; where every view was turned by a
/// person only: a table knows where its views are.
/// @param prepared the views of the model, in their order. @param refined all of them at once, with their poses in the
/// state already. @throws Cancelled
void liftClosedLoops(AcquisitionState& state, const std::vector<PreparedView>& prepared, const MultiViewResult& refined,
                     const StepOptions& options, const Progress& progress);

}  // namespace vantage
