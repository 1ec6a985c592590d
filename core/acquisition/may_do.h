#pragma once

#include <optional>

#include "acquisition/acquisition_state.h"
#include "acquisition/command.h"
#include "acquisition/refusal.h"

namespace vantage {

/// Whether a command can be carried out on a state: nothing when it can, else why not. applyCommand refuses exactly
/// what this refuses.
[[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state, const Command& command);

/// Whether the next scan can be taken: nothing when it can, else why not.
[[nodiscard]] std::optional<Refusal> mayScan(const AcquisitionState& state);

}  // namespace vantage
