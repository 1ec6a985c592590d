#pragma once

#include "acquisition/acquisition_state.h"
#include "acquisition/command.h"
#include "acquisition/command_tools.h"
#include "base/progress.h"

namespace vantage {

/// The state that a command leads to. The same state, command and scans give the same bytes: a session is replayed by
/// applying its commands again. Steps reported: register, integrate and those of the planner.
/// @throws InvalidInput when the command does not fit the state (see mayDo); Cancelled. The state given stays as it is.
[[nodiscard]] AcquisitionState applyCommand(const AcquisitionState& state, const Command& command,
                                            const CommandInput& input, const Progress& progress);

}  // namespace vantage
