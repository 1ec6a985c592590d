#include "cli/rig_arguments.h"

#include "acquisition/setting_lookup.h"
#include "base/errors.h"

namespace vantage {

void RigArguments::addDevicesTo(CLI::App& command) {
  command.add_option("--sensor", sensor_, "simulated, folder:DIR, openni2[:URI] or replay:SESSION")
      ->type_name("SENSOR");
  command.add_option("--table", table_, "simulated, none, hand or serial:PORT[,PROTOCOL]")->type_name("TABLE");
  command.add_option("--rig", rig_, "All devices in one file (JSON), also programs");
}

void RigArguments::addTo(CLI::App& command) {
  addDevicesTo(command);
  command.add_option("--scanner", scanner_, "Scanner profile (JSON)");
  command.add_option("--calibration", calibration_, "Calibration of the table (JSON), as 'calibrate' writes it");
}

RigFile RigArguments::described() const {
  RigFile file;
  if (!rig_.empty()) file = readRigFile(rig_);
  if (!sensor_.empty()) file.rig.sensor = parseSensor(sensor_);
  if (!table_.empty()) file.rig.table = parseTable(table_);
  if (!scanner_.empty()) file.rig.scanner = scanner_;
  if (!calibration_.empty()) file.rig.calibration = calibration_;
  return file;
}

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
  return readProfileSource(rig.scanner);
}

AcquisitionSettings withCut(AcquisitionSettings settings, const RigFile& /*file*/) {
  return settings;
}

}  // namespace vantage
