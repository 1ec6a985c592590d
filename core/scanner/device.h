#pragma once

#include <optional>
#include <string>

#include "base/progress.h"

namespace vantage {

/// Something an operator owns that takes part in scanning. It does what it is told and says what came of it; it decides
/// nothing. One thread at a time talks to it.
///
/// What takes time takes a Progress: every report is a sign of life, and a stop that was requested is answered soon.
/// identity and notReady answer at once, from what is known. Destroying a device closes it.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  /// Its kind and, where it tells them, maker and serial number: "simulated turntable". Messages begin with it.
  [[nodiscard]] virtual std::string identity() const = 0;

  /// Connects. A device that is open stays as it is.
  /// @throws DeviceError that says what the operator can do about it; Cancelled
  virtual void open(const Progress& progress) = 0;

  /// Disconnects. A device that is closed stays as it is.
  virtual void close() noexcept = 0;

  /// What keeps it from being used now, as the end of a sentence that begins with its identity; nothing when it can.
  [[nodiscard]] virtual std::optional<std::string> notReady() const = 0;
};

}  // namespace vantage
