#include "devices/serial/serial_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/errors.h"
#include "base/plain_text.h"
#include "devices/serial/line_speed.h"
#include "devices/serial/port_holder.h"

namespace vantage {
namespace {

constexpr std::chrono::milliseconds kWriting{400};

std::string pathOf(const std::string& port) {
  return port.find('/') == std::string::npos ? "/dev/" + port : port;
}

std::string reason(int error) {
  return std::strerror(error);  // NOLINT(concurrency-mt-unsafe): glibc's is safe
}

[[noreturn]] void refuseBusy(const std::string& path, const std::string& holder) {
  throw DeviceError(plainText(path) + ": is in use by " + (holder.empty() ? "another program" : holder) +
                    "; end that, or wait until it lets go of the port");
}

// What keeps a port from being opened, and what to do about it.
[[noreturn]] void refuse(const std::string& path, int error) {
  const std::string name = plainText(path);
  if (error == EACCES || error == EPERM)
    throw DeviceError(name +
                      ": permission denied; add yourself to the group dialout (sudo adduser USER dialout), then log "
                      "out and in again");
  if (error == ENOENT || error == ENXIO || error == ENODEV)
    throw DeviceError(name + ": there is no such port; plug the table in, switch it on, and see which ports there are");
  if (error == EBUSY) refuseBusy(path, holderOf(path));
  if (error == ENOTTY || error == EISDIR || error == EINVAL)
    throw DeviceError(name + ": is no serial port; choose one from the list of ports");
  throw DeviceError(name + ": cannot be opened: " + reason(error));
}

}  // namespace

class SerialPort::Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  // What was not sent yet would hold up the closing of a port whose device is gone.
  ~Descriptor() {
    ::tcflush(number_, TCIOFLUSH);
    ::ioctl(number_, TIOCNXCL);
    ::close(number_);
  }

  [[nodiscard]] int number() const { return number_; }

  // Events of poll that have come within the time.
  [[nodiscard]] short await(short events, std::chrono::milliseconds longest) const {
    pollfd waiting{number_, events, 0};
    const auto end = std::chrono::steady_clock::now() + longest;
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      const int found = ::poll(&waiting, 1, left.count() > 0 ? static_cast<int>(left.count()) : 0);
      if (found >= 0 || errno != EINTR) return found > 0 ? waiting.revents : short{0};
    }
  }

 private:
  int number_;
};

SerialPort::SerialPort(const std::string& port) : path_(pathOf(port)) {}

SerialPort::~SerialPort() = default;

void SerialPort::open(int baud) {
  close();
  if (const std::string holder = holderOf(path_); !holder.empty()) refuseBusy(path_, holder);
  const int number = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (number < 0) refuse(path_, errno);
  auto descriptor = std::make_unique<Descriptor>(number);
  if (::isatty(number) == 0) refuse(path_, ENOTTY);
  if (::flock(number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) refuse(path_, EBUSY);
  ::ioctl(number, TIOCEXCL);
  if (const int error = makeRaw(number, baud); error != 0)
    throw DeviceError(plainText(path_) + ": cannot be set to " + std::to_string(baud) + " baud: " + reason(error));
  // A pseudo terminal has no such lines, which is no reason not to use it.
  int lines = TIOCM_DTR | TIOCM_RTS;
  ::ioctl(number, TIOCMBIS, &lines);
  ::tcflush(number, TCIFLUSH);
  descriptor_ = std::move(descriptor);
}

void SerialPort::close() noexcept {
  descriptor_.reset();
}

void SerialPort::vanished(const std::string& how) {
  close();
  throw DeviceError(plainText(path_) + ": the port has vanished (" + how +
                    "): the table was unplugged or switched off; plug it in and connect again, and it counts from "
                    "where it then stands");
}

void SerialPort::write(std::string_view bytes) {
  if (!isOpen()) throw DeviceError(plainText(path_) + ": is not connected");
  const auto end = std::chrono::steady_clock::now() + kWriting;
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_->number(), bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno != EAGAIN && errno != EINTR) vanished(reason(errno));
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0)
      throw DeviceError(plainText(path_) + ": takes no more bytes; unplug the table, plug it in and connect again");
    if ((descriptor_->await(POLLOUT, left) & POLLHUP) != 0) vanished("hung up");
  }
}

std::string SerialPort::read(std::chrono::milliseconds longest) {
  if (!isOpen()) throw DeviceError(plainText(path_) + ": is not connected");
  const short events = descriptor_->await(POLLIN, longest);
  if (events == 0) return {};
  char bytes[1024];
  const ssize_t count = ::read(descriptor_->number(), bytes, sizeof bytes);
  if (count > 0) return {bytes, static_cast<std::size_t>(count)};
  if (count < 0 && (errno == EAGAIN || errno == EINTR) && (events & (POLLHUP | POLLERR | POLLNVAL)) == 0) return {};
  vanished(count < 0 ? reason(errno) : "hung up");
}

}  // namespace vantage
