#pragma once

#include <memory>

#include "scanner/positioner.h"
#include "scanner/range_sensor.h"
#include "scanner/turntable.h"

namespace vantage {

/// The devices that scans are taken with. Copies share them.
struct Rig {
  std::shared_ptr<RangeSensor> sensor;
  std::shared_ptr<Positioner> positioner;
  std::shared_ptr<Turntable> table = nullptr;  ///< of the positioner, where it can be jogged, homed and calibrated
};

/// The same rig with both devices open. @throws DeviceError, Cancelled
[[nodiscard]] Rig opened(Rig rig, const Progress& progress = {});

/// One scan: moves to a position, captures there, and puts the pose as it was reached, and how it is known, into the
/// image.
/// @throws DeviceError, also when a device is not ready: then nothing has moved; Cancelled
[[nodiscard]] RangeImage scanFrom(const Rig& rig, int position, const Progress& progress);

}  // namespace vantage
