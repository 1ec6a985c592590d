#pragma once

#include <QString>
#include <cstdint>
#include <optional>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// How an acquisition ended and what that leaves: who ended it, what a further view would show. For one that goes on,
/// that it does.
[[nodiscard]] QString endingText(const AcquisitionState& state);

/// That a scan did not find its place, and why.
[[nodiscard]] QString failedScanText(std::int64_t number, std::optional<int> position, const Finding& finding);

/// The same of the last scan, with what can be done about it; empty when it did find its place.
[[nodiscard]] QString failedScanText(const AcquisitionState& state);

}  // namespace vantage
