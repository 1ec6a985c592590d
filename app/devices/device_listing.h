#pragma once

#include <string>
#include <vector>

#include "base/progress.h"

namespace vantage {

/// One device that is connected, or a place where one may be.
struct ListedDevice {
  std::string kind;         ///< "serial", "camera"
  std::string name;         ///< what it is opened by: a port, an address
  std::string description;  ///< what it says of itself when it is plugged in; may be empty
  bool asked = false;       ///< whether it was asked what it is
  std::string protocol;     ///< that it answers to; empty for none
  std::string answer;       ///< the protocol's title, or why there is none; empty when it was not asked
};

/// The serial ports of this machine. Those on USB are asked what they are, which resets most boards; others only when
/// they are named, because who knows what listens there.
/// @param port asked alone, when it is not empty: also one that is in no list, as a pseudo terminal
/// @throws IoError, InvalidInput when the profiles of turntables cannot be read; Cancelled
[[nodiscard]] std::vector<ListedDevice> listSerialPorts(const std::string& port, const Progress& progress);

/// The depth cameras that are connected, with what they measure, or why they cannot be used. None where OpenNI2 does
/// not start, or the program was built without it. @throws Cancelled
[[nodiscard]] std::vector<ListedDevice> listCameras(const Progress& progress);

}  // namespace vantage
