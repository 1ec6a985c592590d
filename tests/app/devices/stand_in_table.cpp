#include "stand_in_table.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <regex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vantage::testing {
namespace {

constexpr double kSpeed = 300.0;  // [deg/s]

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

// The number after a letter of a command; a fallback when it is not there.
double after(const std::string& line, char letter, double fallback) {
  const std::size_t at = line.find(letter);
  return at == std::string::npos ? fallback : std::stod(line.substr(at + 1));
}

// What all boards share: a motor, and a mishap in its second move.
class Board : public StandInFirmware {
 public:
  explicit Board(const StandInOptions& options) : o_(options) {}

  std::string tick(double seconds) override {
    std::string said;
    if (moving_) said = advance(seconds);
    said += later_;
    later_.clear();
    return silent_ ? std::string() : said;
  }
  [[nodiscard]] double degrees() const override { return position_ / o_.unitsPerDegree; }

 protected:
  virtual std::string greeting() { return {}; }
  virtual std::string arrived() { return {}; }
  virtual std::string mishap() { return {}; }

  [[nodiscard]] bool now(Mishap mishap) const { return o_.mishap == mishap && moves_ == 2; }

  void go(double to) {
    ++moves_;
    begin_ = position_;
    to_ = to;
    moving_ = true;
    struck_ = false;
  }

  std::string restart() {
    position_ = to_ = 0.0;
    moving_ = false;
    return greeting();
  }

  std::string advance(double seconds) {
    const bool half = std::abs(position_ - begin_) >= 0.5 * std::abs(to_ - begin_);
    if (half && !struck_ && moves_ == 2) {
      struck_ = true;
      if (now(Mishap::Restart)) return restart();
      if (now(Mishap::Silence)) silent_ = true;
      if (now(Mishap::StopsShort)) {
        moving_ = false;
        return arrived();
      }
      const std::string said = mishap();
      if (!said.empty()) return said;
    }
    if (now(Mishap::Jam) && struck_) return {};
    const double step = kSpeed * o_.unitsPerDegree * seconds;
    position_ = std::abs(to_ - position_) <= step ? to_ : position_ + std::copysign(step, to_ - position_);
    if (position_ != to_) return {};
    moving_ = false;
    return arrived();
  }

  StandInOptions o_;
  double position_ = 0.0, begin_ = 0.0, to_ = 0.0;  // [units]
  int moves_ = 0;
  bool moving_ = false, struck_ = false, silent_ = false;
  std::string later_;
};

class Grbl final : public Board {
 public:
  using Board::Board;

  std::string start() override {
    locked_ = o_.locked;
    return restart();
  }

  std::string hear(char c) override {
    if (silent_) return {};
    if (c == '?') return report();
    if (c == '!') return halt();
    if (c == '\x18') return softReset();
    if (c != '\n') {
      line_ += c;
      return {};
    }
    const std::string line = std::exchange(line_, {});
    return obey(line);
  }

 private:
  std::string greeting() override {
    door_ = held_ = false;
    return "\r\nGrbl 1.1h ['$' for help]\r\n" + std::string(locked_ ? "[MSG:'$H'|'$X' to unlock]\r\n" : "");
  }

  std::string mishap() override {
    if (now(Mishap::Alarm)) {
      moving_ = false;
      locked_ = true;
      return "ALARM:1\r\n[MSG:Reset to continue]\r\n";
    }
    if (now(Mishap::Door)) {
      moving_ = false;
      door_ = true;
      return "[MSG:Check Door]\r\n";
    }
    return o_.noise ? "[MSG:Pgm End]\r\n>G54:ok\r\n\xff\x01garbage<Idle|MPos:9\r\n" : "";
  }

  std::string halt() {
    held_ = true;
    moving_ = false;
    return {};
  }

  std::string softReset() {
    const bool lost = std::exchange(moving_, false);
    locked_ = locked_ || lost;
    return (lost ? "ALARM:3\r\n" : "") + greeting();
  }

  std::string obey(const std::string& line) {
    if (line == "$X") {
      locked_ = false;
      return "[MSG:Caution: Unlocked]\r\nok\r\n";
    }
    if (line == "$$")
      return "$10=1\r\n$13=" + std::string(o_.inches ? "1" : "0") + "\r\n$22=" + (o_.locked ? "1" : "0") + "\r\nok\r\n";
    if (line == "$H") {
      position_ = 0.0;
      locked_ = false;
      return o_.locked ? "ok\r\n" : "error:5\r\n";
    }
    if (line.empty()) return "ok\r\n";
    if (locked_) return "error:9\r\n";
    const char letter = "XYZA"[o_.axis];
    if (line.find(letter) == std::string::npos) return "error:20\r\n";
    if (moves_ == 1 && o_.mishap == Mishap::CommandLost && !std::exchange(lost_, true)) return {};
    if (moves_ == 1 && o_.mishap == Mishap::Refuses && !std::exchange(lost_, true)) return "error:20\r\n";
    go(after(line, letter, 0.0));
    return now(Mishap::OkLost) ? "" : "ok\r\n";
  }

  std::string report() {
    const double unit = o_.inches ? 1.0 / 25.4 : 1.0;
    const std::string state = door_ ? "Door:0" : held_ ? "Hold:0" : locked_ ? "Alarm" : moving_ ? "Run" : "Idle";
    std::string text = "<" + state;
    const bool tellsOffset = reports_++ % 5 == 4;
    if (tellsOffset) text += "|WCO:" + list(o_.offset * unit);
    text += o_.workOnly ? "|WPos:" + list((position_ - o_.offset) * unit) : "|MPos:" + list(position_ * unit);
    return text + "|FS:0,0>\r\n";
  }

  [[nodiscard]] std::string list(double value) const {
    std::string text;
    for (std::size_t i = 0; i < o_.axes; ++i) (text += i == 0 ? "" : ",") += i == o_.axis ? number(value) : "0.000";
    return text;
  }

  std::string line_;
  bool locked_ = false, held_ = false, door_ = false, lost_ = false;
  int reports_ = 0;
};

class Marlin final : public Board {
 public:
  using Board::Board;
  std::string start() override { return restart(); }

  std::string hear(char c) override {
    if (silent_) return {};
    if (c != '\n') {
      line_ += c;
      return {};
    }
    const std::string line = std::exchange(line_, {});
    if (line == "M410") {  // obeyed at once, whatever waits
      moving_ = false;
      to_ = position_;
    }
    waiting_.push_back(line);
    return work();
  }

  std::string tick(double seconds) override {
    std::string said = Board::tick(seconds);
    if (!silent_) said += work();
    return said;
  }

 private:
  std::string greeting() override {
    waiting_.clear();
    return "start\necho:Marlin 2.1.2\n";
  }

  // Lines in turn; M400 holds up those after it.
  std::string work() {
    std::string said;
    while (!waiting_.empty() && !(waiting_.front() == "M400" && moving_)) {
      const std::string line = waiting_.front();
      waiting_.erase(waiting_.begin());
      said += obey(line);
    }
    return said;
  }

  std::string obey(const std::string& line) {
    if (line.empty()) return {};
    if (line == "M115") return "FIRMWARE_NAME:Marlin 2.1.2 SOURCE_CODE_URL:none\nok\n";
    if (line == "M114")
      return "X:" + number(to_) + " Y:0.00 Z:0.00 E:0.00 Count X:" + std::to_string(std::lround(80 * position_)) +
             " Y:0 Z:0\nok\n";
    if (line.starts_with("G1")) {
      if (moves_ == 1 && o_.mishap == Mishap::Refuses) return "Error:cold\nok\n";
      go(after(line, 'X', 0.0));
      if (now(Mishap::OkLost)) return {};
    }
    return "ok\n";
  }

  std::string line_;
  std::vector<std::string> waiting_;
};

class FabScan final : public Board {
 public:
  using Board::Board;
  std::string start() override {
    static_cast<void>(restart());
    return {};
  }

  std::string hear(char c) override {
    std::string said(1, c);
    line_ += c;
    if (c != '\n') return said;
    const std::string line = std::exchange(line_, {});
    if (line.starts_with("M200")) said += "v.1\r\n";
    if (!line.starts_with("G04")) return said + ">";
    go(position_ + after(line, 'T', 0.0));
    return said;
  }

 private:
  std::string arrived() override { return now(Mishap::EndLost) ? "" : ">"; }
  std::string line_;
};

class Comxim final : public Board {
 public:
  using Board::Board;
  std::string start() override { return "#" + restart(); }

  std::string hear(char c) override {
    if (c == '#' || c == '\n') return {};
    line_ += c;
    if (c != ';') return {};
    const std::string line = std::exchange(line_, {});
    if (line.starts_with("CT+TRUNSINGLE")) {
      if (moves_ == 1 && o_.mishap == Mishap::Refuses) return "CR+ERR=71;";
      const double by = std::stod(line.substr(line.find(',') + 1));
      go(position_ + (line.find("(1,") == std::string::npos ? -by : by));
      return now(Mishap::OkLost) ? "#" : "CR+#OK;";
    }
    if (line == "CT+STOP();") moving_ = false;
    return line == ";" ? "CR+ERR=10;" : "CR+OK;";
  }

  std::string tick(double seconds) override {
    beat_ += seconds;
    std::string said = Board::tick(seconds);
    if (beat_ > 1.0 && !silent_) {
      beat_ = 0.0;
      said += "#";
    }
    return said;
  }

 private:
  std::string arrived() override { return now(Mishap::EndLost) ? "" : "CR+EVENT=TB_PAUSE;CR+EVENT=TB_END;"; }
  std::string line_;
  double beat_ = 0.0;
};

}  // namespace

std::unique_ptr<StandInFirmware> grblStandIn(const StandInOptions& options) {
  return std::make_unique<Grbl>(options);
}
std::unique_ptr<StandInFirmware> marlinStandIn(const StandInOptions& options) {
  return std::make_unique<Marlin>(options);
}
std::unique_ptr<StandInFirmware> fabscanStandIn(const StandInOptions& options) {
  return std::make_unique<FabScan>(options);
}
std::unique_ptr<StandInFirmware> comximStandIn(const StandInOptions& options) {
  return std::make_unique<Comxim>(options);
}

StandInTable::StandInTable(std::unique_ptr<StandInFirmware> firmware)
    : firmware_(std::move(firmware)), master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  char name[128];
  if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0 ||
      ::ptsname_r(master_, name, sizeof name) != 0)
    throw std::runtime_error("there is no pseudo terminal");
  port_ = name;
  // Its settings last while the master lives, and a port that was opened and closed says that it is closed.
  const int slave = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios raw{};
  ::tcgetattr(slave, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(slave, TCSANOW, &raw);
  ::close(slave);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

StandInTable::~StandInTable() {
  if (master_ >= 0) unplug();
}

void StandInTable::unplug() {
  thread_.request_stop();
  thread_.join();
  ::close(master_.exchange(-1));
}

void StandInTable::say(const std::string& text) const {
  if (!text.empty() && ::write(master_, text.data(), text.size()) < 0) return;
}

void StandInTable::run(const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  bool open = false;
  auto last = Clock::now();
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    pollfd waiting{master_, POLLIN, 0};
    ::poll(&waiting, 1, 0);
    const bool connected = (waiting.revents & POLLHUP) == 0;
    if (connected && !open) say(firmware_->start());
    open = connected;
    char bytes[256];
    const ssize_t count = open ? ::read(master_, bytes, sizeof bytes) : 0;
    for (ssize_t i = 0; i < count; ++i) say(firmware_->hear(bytes[i]));
    const auto now = Clock::now();
    const std::string said = firmware_->tick(std::chrono::duration<double>(now - last).count());
    degrees_ = firmware_->degrees();
    if (open) say(said);
    last = now;
  }
}

}  // namespace vantage::testing
