#include "cli/rig_arguments.h"

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

}  // namespace vantage
