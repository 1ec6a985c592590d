#pragma once

#include <optional>

#include "acquisition/next_scan.h"

namespace vantage {

/// The scan that would come next if the acquisition were opened again and allowed one more view: what a further view
/// would show. Nothing when no position is proposed or chosen.
[[nodiscard]] std::optional<ScanFrom> furtherScan(const AcquisitionState& state);

/// The same, had the operator chosen no position.
[[nodiscard]] std::optional<ScanFrom> proposedScan(const AcquisitionState& state);

}  // namespace vantage
