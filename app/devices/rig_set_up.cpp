#include "devices/rig_set_up.h"

#include <utility>

#include "acquisition/setting_lookup.h"
#include "base/errors.h"
#include "scanner/calibration_file.h"

namespace vantage {

bool isSimulated(const RigDescription& rig) {
  const bool sensor = std::holds_alternative<SimulatedSensorDevice>(rig.sensor);
  const bool table = std::holds_alternative<SimulatedTableDevice>(rig.table);
  if (sensor && !table && !std::holds_alternative<HandTableDevice>(rig.table))
    throw InvalidInput("the simulated scanner sees the simulated table only: choose --table simulated or hand");
  if (!sensor && table)
    throw InvalidInput(
        "the simulated table turns before the simulated scanner only: choose --table none, hand or serial:PORT");
  return sensor;
}

ProfileSource profileOf(const RigDescription& rig) {
  if (rig.scanner.empty()) throw InvalidInput("there is no scanner profile: name one with --scanner, or in --rig");
  ProfileSource source = readProfileSource(rig.scanner);
  if (rig.calibration.empty()) return source;
  const TableCalibration calibration = loadCalibration(rig.calibration);
  if (calibration.verdict == CalibrationVerdict::Failed)
    throw InvalidInput(rig.calibration + ": is of a calibration that failed: calibrate again, or go without");
  return withCalibration(std::move(source), calibration);
}

AcquisitionSettings withCut(AcquisitionSettings settings, const RigFile& file) {
  settings.cut = cutForRealScanners();
  for (const auto& [key, value] : file.settings) setText(settingField(key), settings, value);
  return settings;
}

}  // namespace vantage
