#include "devices/real_rig.h"

#include <utility>

#include "base/errors.h"
#include "devices/fixed_place.h"
#include "devices/folder_sensor.h"
#include "devices/openni2_sensor.h"
#include "devices/program_sensor.h"
#include "devices/program_turntable.h"
#include "devices/replay_sensor.h"
#include "devices/serial/table_device.h"
#include "scanner/turntable_positioner.h"

namespace vantage {
namespace {

struct SensorMaking {
  const RealDevices& setUp;

  std::shared_ptr<RangeSensor> operator()(const SimulatedSensorDevice&) const {
    throw InvalidInput("the simulated scanner sees the simulated table only: choose both, or neither");
  }
  std::shared_ptr<RangeSensor> operator()(const OpenNi2Device& device) const {
    return makeOpenNi2Sensor(device, setUp.profile);
  }
  std::shared_ptr<RangeSensor> operator()(const FolderDevice& device) const {
    FolderSensorOptions options{device.folder, setUp.reading};
    options.tableAlwaysTurns = std::holds_alternative<SerialTableDevice>(setUp.rig.table) ||
                               std::holds_alternative<ProgramDevice>(setUp.rig.table);
    return std::make_shared<FolderSensor>(std::move(options), setUp.profile);
  }
  std::shared_ptr<RangeSensor> operator()(const ReplayDevice& device) const {
    return std::make_shared<ReplaySensor>(device.session, setUp.profile, setUp.reading);
  }
  std::shared_ptr<RangeSensor> operator()(const ProgramDevice& device) const {
    return std::make_shared<ProgramSensor>(device, setUp.profile, setUp.reading);
  }
};

struct TableMaking {
  const RealDevices& setUp;
  std::shared_ptr<Turntable> table;

  std::shared_ptr<Positioner> operator()(const SimulatedTableDevice&) const {
    throw InvalidInput("the simulated table turns before the simulated scanner only: choose both, or neither");
  }
  std::shared_ptr<Positioner> operator()(const NoTableDevice&) const {
    return std::make_shared<FixedPlace>(setUp.profile);
  }
  std::shared_ptr<Positioner> operator()(const HandTableDevice&) const {
    if (!setUp.ask) throw InvalidInput("a table turned by hand needs somebody who is asked to turn it");
    return std::make_shared<HandTable>(setUp.profile, setUp.ask, kTurnedByHand);
  }
  template <typename Device>
  std::shared_ptr<Positioner> operator()(const Device& /*turns*/) const {
    return std::make_shared<TurntablePositioner>(setUp.profile, table,
                                                 TurntableUse{setUp.stands, startsByItself(setUp.rig.sensor)});
  }
};

}  // namespace

bool startsByItself(const SensorDevice& sensor) {
  return std::holds_alternative<FolderDevice>(sensor);
}

std::shared_ptr<Turntable> turntableOf(const TableDevice& table) {
  if (const auto* serial = std::get_if<SerialTableDevice>(&table)) return serialTurntable(*serial);
  if (const auto* program = std::get_if<ProgramDevice>(&table)) return std::make_shared<ProgramTurntable>(*program);
  return nullptr;
}

std::shared_ptr<RangeSensor> sensorOf(const RealDevices& setUp) {
  return std::visit(SensorMaking{setUp}, setUp.rig.sensor);
}

Rig realRig(const RealDevices& setUp) {
  const auto table = turntableOf(setUp.rig.table);
  return {sensorOf(setUp), std::visit(TableMaking{setUp, table}, setUp.rig.table), table};
}

}  // namespace vantage
