#pragma once

#include <memory>

#include "base/progress.h"
#include "devices/rig_description.h"
#include "io/scan_reader.h"
#include "scanner/profile.h"
#include "scanner/range_sensor.h"
#include "scanner/turntable.h"

namespace vantage {

/// A sensor and the table that is to be calibrated before it.
struct CalibrationRig {
  std::shared_ptr<RangeSensor> sensor;
  std::shared_ptr<Turntable> table;
  bool startsByItself = false;  ///< the sensor scans whenever the table has come to rest
};

/// Both devices, open. @throws InvalidInput for a table that has no angle of its own; DeviceError, Cancelled
[[nodiscard]] CalibrationRig openCalibrationRig(const RigDescription& rig, const ScanReadingOptions& reading,
                                                const std::shared_ptr<const ScannerProfile>& profile,
                                                const Progress& progress);

}  // namespace vantage
