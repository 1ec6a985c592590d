#include "devices/serial/port_list.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/plain_text.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// The line of an attribute of a device; empty when it has none.
std::string attribute(const fs::path& device, const char* name) {
  std::ifstream in(device / name);
  std::string line;
  std::getline(in, line);
  return plainText(line);
}

// A serial port of a board for which no chip was found.
bool isAbsent(const fs::path& terminal) {
  return attribute(terminal, "type") == "0";
}

// The USB device that a port belongs to: the nearest device above it that has a descriptor.
fs::path usbDeviceOf(const fs::path& terminal, const fs::path& system) {
  std::error_code unknown;
  const fs::path top = fs::canonical(system, unknown);
  if (unknown) return {};
  for (fs::path device = fs::canonical(terminal / "device", unknown);
       !unknown && device != top && device.has_relative_path(); device = device.parent_path())
    if (fs::exists(device / "idVendor", unknown)) return device;
  return {};
}

PortDescription described(const fs::path& terminal, const fs::path& system, const fs::path& port) {
  PortDescription description{port.string(), {}, {}, {}, {}};
  const fs::path usb = usbDeviceOf(terminal, system);
  if (usb.empty()) return description;
  description.description = attribute(usb, "product");
  description.manufacturer = attribute(usb, "manufacturer");
  description.serialNumber = attribute(usb, "serial");
  description.usb = attribute(usb, "idVendor") + ":" + attribute(usb, "idProduct");
  return description;
}

}  // namespace

std::vector<PortDescription> serialPorts() {
  return serialPorts("/sys", "/dev");
}

std::vector<PortDescription> serialPorts(const fs::path& system, const fs::path& devices) {
  std::vector<PortDescription> ports;
  std::error_code unknown;
  fs::directory_iterator terminal(system / "class" / "tty", unknown);
  for (; !unknown && terminal != fs::directory_iterator(); terminal.increment(unknown)) {
    const fs::path port = devices / terminal->path().filename();
    std::error_code missing;
    if (!fs::exists(terminal->path() / "device", missing) || !fs::exists(port, missing) || isAbsent(terminal->path()))
      continue;
    ports.push_back(described(terminal->path(), system, port));
  }
  std::sort(ports.begin(), ports.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return ports;
}

std::string describe(const PortDescription& port) {
  std::string text = port.manufacturer;
  if (!port.description.empty()) text += (text.empty() ? "" : " ") + port.description;
  if (!port.usb.empty()) text += (text.empty() ? "USB " : ", USB ") + port.usb;
  if (!port.serialNumber.empty()) text += ", serial number " + port.serialNumber;
  return text;
}

}  // namespace vantage
