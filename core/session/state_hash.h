#pragma once

#include <cstdint>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// Everything that decides how a session goes on: settings, scans, poses, records, plans and the model. Times do not
/// count. Of plans before the current one only the scores do.
[[nodiscard]] std::uint64_t stateHash(const AcquisitionState& state);

}  // namespace vantage
