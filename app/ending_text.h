#pragma once

#include <QString>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// How an acquisition ended and what that leaves: who ended it, what a further view would show. For one that goes on,
/// that it does.
[[nodiscard]] QString endingText(const AcquisitionState& state);

/// That the last scan did not find its place, and why; empty when it did.
[[nodiscard]] QString failedScanText(const AcquisitionState& state);

}  // namespace vantage
