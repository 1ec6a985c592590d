#include "cli/calibration_rig.h"

#include "base/errors.h"

namespace vantage {

CalibrationRig openCalibrationRig(const SensorDevice& sensor, const TableDevice& table,
                                  const std::shared_ptr<const ScannerProfile>& /*profile*/,
                                  const Progress& /*progress*/) {
  throw DeviceError("the devices " + describe(sensor) + " and " + describe(table) +
                    " cannot be reached by calibrate yet: take the scans with them and give --ranges and --angles");
}

}  // namespace vantage
