#include "cli/calibration_rig.h"

#include "base/errors.h"
#include "devices/real_rig.h"

namespace vantage {

CalibrationRig openCalibrationRig(const RigDescription& rig, const ScanReadingOptions& reading,
                                  const std::shared_ptr<const ScannerProfile>& profile, const Progress& progress) {
  CalibrationRig opened;
  opened.table = turntableOf(rig.table);
  if (!opened.table)
    throw InvalidInput("the table " + describe(rig.table) +
                       " has no angle of its own that could be calibrated: name one as serial:PORT, or take the scans "
                       "and give --ranges and --angles");
  opened.sensor = sensorOf(RealDevices{rig, profile, {}, reading, 0});
  opened.startsByItself = startsByItself(rig.sensor);
  opened.table->open(progress.part(0.0, 0.5));
  opened.sensor->open(progress.part(0.5, 1.0));
  return opened;
}

}  // namespace vantage
