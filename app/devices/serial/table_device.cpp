#include "devices/serial/table_device.h"

#include <utility>

#include "base/errors.h"
#include "devices/serial/serial_port.h"
#include "program/installed_files.h"

namespace vantage {

std::shared_ptr<SerialTurntable> serialTurntable(const SerialTableDevice& device) {
  return std::make_shared<SerialTurntable>(std::make_unique<SerialPort>(device.port),
                                           tableProfilesFor(device.protocol, resourceFolder("turntables")));
}

PortAnswer askPort(const std::string& port, const std::string& protocol, const Progress& progress) {
  const auto table = serialTurntable({port, protocol});
  try {
    table->open(progress);
  } catch (const DeviceError& e) {
    return {{}, e.what()};
  }
  PortAnswer answer{table->protocol(), table->title()};
  table->close();
  return answer;
}

}  // namespace vantage
