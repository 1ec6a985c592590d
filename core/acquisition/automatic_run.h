#pragma once

#include <functional>

#include "acquisition/acquisition_state.h"
#include "acquisition/command.h"
#include "acquisition/scan_source.h"
#include "base/progress.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// Hears of every step that is done: the command and the state it led to.
using StepObserver = std::function<void(const Command&, const AcquisitionState&)>;

struct ScanStep {
  Command command;
  AcquisitionState state;  ///< after it
};

/// One scan from the position that comes next (see nextScan), registered, integrated and planned from.
/// @throws InvalidInput when the acquisition has ended; DeviceError, Cancelled: nothing has changed.
[[nodiscard]] ScanStep scanOnce(const AcquisitionState& state, const ScanSource& scans, const ScannerImages& images,
                                const Progress& progress);

/// Scans, registers, integrates and plans until nothing is left that a view would show, by itself. Baseline strategies
/// share everything but the choice of the position. Steps reported: scan, and those of applyCommand.
/// @param state to go on from; with a profile and settings. One that has ended comes back as it is.
/// @throws DeviceError, Cancelled: what the observer heard of last is whole.
[[nodiscard]] AcquisitionState acquire(AcquisitionState state, const ScanSource& scans, const ScannerImages& images,
                                       const StepObserver& observer, const Progress& progress);

}  // namespace vantage
