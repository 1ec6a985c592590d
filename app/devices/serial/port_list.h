#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// A serial port as its USB descriptor tells.
struct PortDescription {
  std::string path;          ///< "/dev/ttyUSB0"
  std::string description;   ///< "CP2102 USB to UART Bridge Controller"; may be empty
  std::string manufacturer;  ///< may be empty
  std::string serialNumber;  ///< may be empty
  std::string usb;           ///< vendor and product, "10c4:ea60"; empty when it is no USB device
};

/// The serial ports of this machine in order of their paths. Pseudo terminals are not among them.
[[nodiscard]] std::vector<PortDescription> serialPorts();

/// The same as a system tells in other folders.
/// @param system what is /sys in Linux: class/tty has an entry for every port
/// @param devices what is /dev
[[nodiscard]] std::vector<PortDescription> serialPorts(const std::filesystem::path& system,
                                                       const std::filesystem::path& devices);

/// Maker, description and serial number in one line; empty when it tells none.
[[nodiscard]] std::string describe(const PortDescription& port);

}  // namespace vantage
