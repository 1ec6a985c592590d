#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "devices/serial/table_dialog.h"

namespace vantage {

/// Turns a table and finds out when it has arrived: by its reports where it gives them, else by what it says at the end
/// of a move. An ok is no arrival, nor is a report of rest somewhere else.
class TableMotion {
 public:
  /// Called at least ten times a second; throws to leave. @param position [units] as reported last
  using Watch = std::function<void(double fraction, const std::optional<double>& position)>;

  /// @param dialog, profile outlive the motion
  TableMotion(TableDialog& dialog, const TableProfile& profile) : dialog_(dialog), profile_(profile) {}

  /// Turns from one position to another [units], as fine as a command can say. Whoever sees no reports of it lets the
  /// object settle afterwards.
  /// @return where it rests
  /// @throws DeviceError when it is not moved, and stands where it stood; PositionLost otherwise; what the watch throws
  [[nodiscard]] double move(double from, double to, const Watch& watch);

  /// The end of the next move on the way from one position to another [units]: all the way, or as far as it may turn
  /// at a time.
  [[nodiscard]] double nextEnd(double from, double to) const;

  /// Lets the object come to rest after moves that nobody reports.
  void settle(const TableDialog::Pulse& pulse) { pause(profile_.settle, pulse); }

  /// When a report last told that the table turns, in the move that has ended; nothing when none did.
  [[nodiscard]] std::optional<std::chrono::system_clock::time_point> turnedUntil() const { return turnedUntil_; }

  /// Stops it, in so many steps as the time allows; can be gone on with.
  /// @return where it came to rest [units]; nothing when that is not known, or not yet
  [[nodiscard]] std::optional<double> stop(std::chrono::milliseconds patience, const TableDialog::Pulse& pulse);

  /// Waits for the end of a move that was left alone. @return whether it came
  [[nodiscard]] bool awaitEnd(std::chrono::milliseconds patience, const TableDialog::Pulse& pulse);

  /// How long a move by so many units may take.
  [[nodiscard]] std::chrono::milliseconds longestMove(double units) const;

  /// Resets the board, where it can be, and waits until it talks again.
  /// @return false when it does not, or raised an alarm thereby
  [[nodiscard]] bool reset(std::chrono::milliseconds patience, const TableDialog::Pulse& pulse);

  /// The position as commands have it.
  [[nodiscard]] double rounded(double units) const;

 private:
  struct Course;

  double moveReported(Course& course);
  double moveBlind(Course& course);
  bool arrived(Course& course, const StatusReport& report);
  void checkRest(Course& course, const StatusReport& report);
  void pause(std::chrono::milliseconds time, const TableDialog::Pulse& pulse);
  [[nodiscard]] std::optional<double> awaitRest(std::chrono::milliseconds patience, const TableDialog::Pulse& pulse);
  [[nodiscard]] std::string command(double from, double to) const;
  [[nodiscard]] double degreesOf(double units) const { return units * 360.0 / profile_.unitsPerTurn; }

  TableDialog& dialog_;
  const TableProfile& profile_;
  std::optional<std::chrono::system_clock::time_point> turnedUntil_;
};

}  // namespace vantage
