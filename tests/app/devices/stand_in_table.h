#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace vantage::testing {

/// The other end of a line: what a board says when its port is opened, to what it hears, and as time goes by.
class StandInFirmware {
 public:
  virtual ~StandInFirmware() = default;
  virtual std::string start() = 0;
  virtual std::string hear(char c) = 0;
  virtual std::string tick(double seconds) = 0;
  /// Where the plate stands.
  [[nodiscard]] virtual double degrees() const = 0;
};

/// What goes wrong, in the second move.
enum class Mishap { None, Restart, Alarm, Jam, StopsShort, Door, Refuses, CommandLost, OkLost, Silence, EndLost };

/// How a board is set.
struct StandInOptions {
  Mishap mishap = Mishap::None;
  std::size_t axis = 0;
  std::size_t axes = 3;
  double unitsPerDegree = 1.0;
  bool workOnly = false;  ///< tells work coordinates, their offset in every fifth report
  bool inches = false;
  double offset = 0.0;
  bool locked = false;  ///< has an index, and is locked until it is found or unlocked
  bool noise = false;   ///< pushes messages that nobody asked for, and garbage
};

[[nodiscard]] std::unique_ptr<StandInFirmware> grblStandIn(const StandInOptions& options);
[[nodiscard]] std::unique_ptr<StandInFirmware> marlinStandIn(const StandInOptions& options);
[[nodiscard]] std::unique_ptr<StandInFirmware> fabscanStandIn(const StandInOptions& options);
[[nodiscard]] std::unique_ptr<StandInFirmware> comximStandIn(const StandInOptions& options);

/// A firmware behind a pseudo terminal, on a thread of its own, for as long as this lives.
class StandInTable {
 public:
  explicit StandInTable(std::unique_ptr<StandInFirmware> firmware);
  ~StandInTable();
  StandInTable(const StandInTable&) = delete;
  StandInTable& operator=(const StandInTable&) = delete;

  [[nodiscard]] const std::string& port() const { return port_; }
  /// Where the plate stands, whatever the board says.
  [[nodiscard]] double degrees() const { return degrees_; }
  void unplug();

 private:
  void run(const std::stop_token& stop);
  void say(const std::string& text) const;

  std::unique_ptr<StandInFirmware> firmware_;
  std::atomic<int> master_;
  std::string port_;
  std::atomic<double> degrees_ = 0.0;
  std::jthread thread_;
};

}  // namespace vantage::testing
