#pragma once

#include "devices/device_factory.h"
#include "scanner/turntable.h"

namespace vantage {

/// The devices of a set-up, not yet open.
/// @throws InvalidInput for a description that no device can be made of, with what to change
[[nodiscard]] Rig realRig(const RealDevices& setUp);

/// The sensor of a set-up alone. @throws as realRig
[[nodiscard]] std::shared_ptr<RangeSensor> sensorOf(const RealDevices& setUp);

/// Whether a sensor scans whenever the table has come to rest, and waits for that.
[[nodiscard]] bool startsByItself(const SensorDevice& sensor);

/// The turntable of a set-up alone, for jogging, homing and calibrating; null where no table turns to angles.
[[nodiscard]] std::shared_ptr<Turntable> turntableOf(const TableDevice& table);

}  // namespace vantage
