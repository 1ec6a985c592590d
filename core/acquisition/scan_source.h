#pragma once

#include <functional>

#include "acquisition/steps.h"
#include "base/progress.h"
#include "scanner/device.h"

namespace vantage {

/// Where an acquisition gets its scans from: one from a position of the workspace, with its number in the session.
/// @throws DeviceError, IoError, Cancelled
using ScanSource = std::function<NumberedScan(int position, const Progress& progress)>;

/// Scans of a device, numbered from 0, for acquisitions that are not kept. The device must outlive it.
[[nodiscard]] ScanSource countedScans(ScannerDevice& scanner);

}  // namespace vantage
