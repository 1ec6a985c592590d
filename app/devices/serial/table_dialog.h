#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.h"
#include "devices/serial/message_stream.h"
#include "devices/serial/serial_line.h"
#include "devices/serial/status_reader.h"

namespace vantage {

/// The table no longer stands where it was believed to stand.
class PositionLost : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

/// What a message of a table is, by the patterns of its profile.
enum class MessageKind { Ok, Error, Done, Greeting, Alarm, Status, Echo, Other };

struct TableMessage {
  MessageKind kind = MessageKind::Other;
  std::string text;
  std::string code;  ///< of errors and alarms
};

/// Talks with a table: sends commands and sorts what comes back into answers, reports and events, whenever they come.
class TableDialog {
 public:
  using Clock = std::chrono::steady_clock;
  /// Called at least ten times a second while something is waited for; throws to leave.
  using Pulse = std::function<void()>;

  /// @param line, profile outlive the dialog
  TableDialog(SerialLine& line, const TableProfile& profile);

  /// Sends a command with its line end.
  void send(const std::string& command);
  /// Sends a byte that is obeyed at once.
  void sendByte(const std::string& byte) { line_.write(byte); }

  /// The next message; nothing when none comes within the time.
  /// @throws PositionLost for a greeting that was not expected and for an alarm; DeviceError when the port vanished;
  /// whatever the pulse throws
  [[nodiscard]] std::optional<TableMessage> next(std::chrono::milliseconds patience, const Pulse& pulse);

  /// A command whose ok is waited for. @return the answer; nothing when none came within the time, which is no proof
  /// that it was not obeyed. @throws as next
  [[nodiscard]] std::optional<TableMessage> command(const std::string& command, std::chrono::milliseconds patience,
                                                    const Pulse& pulse);

  /// Asks where the table is and what it does, again and again until it answers.
  /// @return nothing when it does not within the time. @throws as next
  [[nodiscard]] std::optional<StatusReport> askStatus(std::chrono::milliseconds patience, const Pulse& pulse);

  /// Reads what has come and was not asked for, until the line is quiet for so long. @throws as next
  void drain(std::chrono::milliseconds quiet, const Pulse& pulse);

  /// The error that came since it was last taken.
  [[nodiscard]] std::optional<std::string> takeError() { return std::exchange(error_, std::nullopt); }
  /// Whether an ok came since the last command.
  [[nodiscard]] bool acknowledged() const { return acknowledged_; }
  /// When something came last.
  [[nodiscard]] Clock::time_point heardAt() const { return heard_; }
  /// Whether anything came within the time before now.
  [[nodiscard]] bool heardWithin(std::chrono::milliseconds time) const { return Clock::now() - heard_ < time; }

  /// Whether greetings and alarms are part of what was asked for, as after a reset.
  void expectRestart(bool expected) { restartExpected_ = expected; }
  [[nodiscard]] bool greeted() const { return greeted_; }
  void forgetGreeting() { greeted_ = false; }

  [[nodiscard]] StatusReader& reader() { return reader_; }
  /// What came last, fit for a message to the operator.
  [[nodiscard]] std::string lastHeard() const;

  /// "error:9 (the board is locked)"
  [[nodiscard]] std::string meaning(const std::string& kind, const std::string& code) const;

 private:
  [[nodiscard]] TableMessage classify(const std::string& text);
  void handle(const TableMessage& message);
  void beat();

  SerialLine& line_;
  const TableProfile& profile_;
  MessageStream stream_;
  StatusReader reader_;
  std::optional<StatusReport> report_;
  std::optional<std::string> error_;
  std::string sent_, last_;
  bool acknowledged_ = false, restartExpected_ = false, greeted_ = false;
  Clock::time_point heard_{}, beaten_{};
};

}  // namespace vantage
