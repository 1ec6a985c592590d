#pragma once

#include <functional>
#include <memory>

#include "acquisition/acquisition_state.h"
#include "acquisition/command.h"
#include "base/progress.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// What commands are carried out with.
struct CommandInput {
  /// Scans by their number. @throws InvalidInput for a number that no scan has.
  std::function<std::shared_ptr<const RangeImage>(std::int64_t)> scan;
  const ScannerImages* images = nullptr;  ///< of the state's profile; without them no plan is made
  PhaseTimes before = {};                 ///< what was spent on the command before it came here, for the record
};

/// The state that a command leads to. The same state, command and scans give the same bytes: a session is replayed by
/// applying its commands again. Steps reported: register, integrate and those of the planner.
/// @throws InvalidInput when the command does not fit the state (see mayDo); Cancelled. The state given stays as it is.
[[nodiscard]] AcquisitionState applyCommand(const AcquisitionState& state, const Command& command,
                                            const CommandInput& input, const Progress& progress);

}  // namespace vantage
