#pragma once

#include <functional>

#include "acquisition/acquisition_state.h"
#include "acquisition/steps.h"
#include "base/progress.h"
#include "scanner/device.h"

namespace vantage {

/// Hears of every step that is done, with the state it led to.
using StepObserver = std::function<void(const AcquisitionState&)>;

/// Scans, registers, integrates and plans until nothing is left that a view would show, by itself. After a
/// registration that failed, a position with clearly more overlap is tried; after four failures in a row the run ends.
/// Baseline strategies share everything but the choice of the position. Steps reported: scan, and those of the steps.
/// @param state to go on from; with a profile, usually without views.
/// @throws DeviceError, Cancelled: what the observer heard of last is whole.
[[nodiscard]] AcquisitionState acquire(AcquisitionState state, ScannerDevice& scanner, const ScannerImages& images,
                                       const AcquisitionSettings& settings, const StepObserver& observer,
                                       const Progress& progress);

}  // namespace vantage
