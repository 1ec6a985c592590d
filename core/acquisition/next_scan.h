#pragma once

#include <optional>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// Where an acquisition goes on, or why it ends.
struct NextScan {
  int position = -1;                       ///< -1 when it ends, or when a plan must be made first
  std::optional<PositionScore> predicted;  ///< what the plan promises of the position
  Termination termination = Termination::Running;
};

/// What comes after a state: the position that the operator chose, else the plan's, else the strategy's. After a
/// registration that failed, the best position with clearly more overlap; after four failures in a row the acquisition
/// ends. Depends on the state only, so that an interrupted run goes on as it would have.
[[nodiscard]] NextScan nextScan(const AcquisitionState& state);

}  // namespace vantage
