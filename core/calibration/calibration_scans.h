#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "calibration/sample_motion.h"
#include "scanner/range_sensor.h"
#include "scanner/turntable.h"

namespace vantage {

/// Table angles that tell an axis well, from 0 [deg]: turns that grow, so that no symmetry of an object repeats in all
/// of them, over 60 to 200 degrees. @throws InvalidInput unless there are 3 to 12
[[nodiscard]] std::vector<double> calibrationAngles(int scans);

/// Turns the table to each angle, counted from where it stands, and scans there. Both devices are open. The scans have
/// the angles that the table says it reached.
/// @param turnFirst the table turns once round before the first scan: for scanners that wait for a move
/// @throws DeviceError, also for a device that is not ready: then nothing has moved; Cancelled
[[nodiscard]] std::vector<CalibrationScan> takeCalibrationScans(RangeSensor& sensor, Turntable& table,
                                                                std::span<const double> angles,
                                                                const Progress& progress, bool turnFirst = false);

}  // namespace vantage
