#pragma once

#include <memory>

#include "devices/serial/serial_line.h"

namespace vantage {

/// A serial port of this machine, or a pseudo terminal: a path that somebody typed. Without flow control, 8 data bits,
/// no parity, one stop bit; nobody else can open it meanwhile.
///
/// Made of what POSIX and Linux have, not of QSerialPort: that one belongs to the thread that opened it, while the
/// calls of a device come from changing threads (see Patience), and it reports a port that vanished as errors of
/// reading without end.
class SerialPort final : public SerialLine {
 public:
  /// @param port a path, or the name of a device file in /dev
  explicit SerialPort(const std::string& port);
  ~SerialPort() override;

  [[nodiscard]] const std::string& name() const override { return path_; }
  void open(int baud) override;
  [[nodiscard]] bool isOpen() const override { return descriptor_ != nullptr; }
  void close() noexcept override;
  void write(std::string_view bytes) override;
  [[nodiscard]] std::string read(std::chrono::milliseconds longest) override;

 private:
  class Descriptor;

  // Closes the port. @throws DeviceError always
  [[noreturn]] void vanished(const std::string& how);

  std::string path_;
  std::unique_ptr<Descriptor> descriptor_;
};

}  // namespace vantage
