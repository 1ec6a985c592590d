#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace vantage {

/// A line to a device that takes and sends bytes. No call takes longer than half a second. Any thread may use it, one
/// at a time. Messages begin with its name.
class SerialLine {
 public:
  SerialLine() = default;
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;
  virtual ~SerialLine() = default;

  [[nodiscard]] virtual const std::string& name() const = 0;

  /// Opens it anew at a speed [bit/s]; closed first when it is open.
  /// @throws DeviceError that says what the operator can do about it
  virtual void open(int baud) = 0;
  [[nodiscard]] virtual bool isOpen() const = 0;
  virtual void close() noexcept = 0;

  /// @throws DeviceError when it cannot be written to, as when it was unplugged; it is closed then
  virtual void write(std::string_view bytes) = 0;

  /// What has come; waits up to `longest` for the first byte. Empty when none came.
  /// @throws DeviceError when it cannot be read from, as when it was unplugged; it is closed then
  [[nodiscard]] virtual std::string read(std::chrono::milliseconds longest) = 0;
};

}  // namespace vantage
