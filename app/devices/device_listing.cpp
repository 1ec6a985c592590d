#include "devices/device_listing.h"

#include <algorithm>

#include "base/errors.h"
#include "devices/openni2_sensor.h"
#include "devices/serial/port_list.h"
#include "devices/serial/table_device.h"

namespace vantage {
namespace {

void ask(ListedDevice& device, const Progress& progress) {
  PortAnswer answer = askPort(device.name, {}, progress);
  device.asked = true;
  device.protocol = std::move(answer.protocol);
  device.answer = std::move(answer.title);
}

}  // namespace

std::vector<ListedDevice> listSerialPorts(const std::string& port, const Progress& progress) {
  std::vector<ListedDevice> devices;
  std::vector<bool> wanted;
  for (const PortDescription& found : serialPorts()) {
    const bool named = found.path == port || found.path == "/dev/" + port;
    if (!port.empty() && !named) continue;
    devices.push_back({"serial", found.path, describe(found), false, {}, {}});
    wanted.push_back(named || !found.usb.empty());
  }
  if (!port.empty() && devices.empty()) {
    devices.push_back({"serial", port, {}, false, {}, {}});
    wanted.push_back(true);
  }
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const double count = static_cast<double>(devices.size());
    const double from = static_cast<double>(i) / count;
    if (wanted[i]) ask(devices[i], progress.part(from, from + 1.0 / count, "asking " + devices[i].name));
  }
  return devices;
}

std::vector<ListedDevice> listCameras(const Progress& progress) {
  std::vector<ListedDevice> devices;
  try {
    for (const CameraInfo& camera : connectedCameras(progress)) {
      const std::string measures = camera.model ? describe(*camera.model) : std::string();
      const bool usable = camera.problem.empty();
      devices.push_back({"camera", camera.uri, camera.vendor + " " + camera.name, true, usable ? "openni2" : "",
                         usable ? measures : camera.problem});
    }
  } catch (const DeviceError&) {
    // No camera can be reached that way; who names one is told why.
  }
  return devices;
}

}  // namespace vantage
