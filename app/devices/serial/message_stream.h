#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace vantage {

/// Cuts the bytes of a line into messages, however they come: split, merged, with any line end, with rubbish between.
class MessageStream {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// @param ends characters, each of which ends a message; empty messages do not count.
  /// @param prompt a character that is a message of its own where it stands alone, or came some time after rubbish, and
  /// the line then rests; or none.
  /// @param heartbeat a character that means nothing wherever it comes; or none.
  MessageStream(std::string ends, std::string prompt, std::string heartbeat);

  void feed(std::string_view bytes, Time now);
  /// The next message without its end.
  [[nodiscard]] std::optional<std::string> next(Time now);
  void clear();

 private:
  void take(char c);
  [[nodiscard]] bool isPrompt() const;

  std::string ends_, prompt_, heartbeat_;
  std::string begun_;
  bool overlong_ = false;
  bool behindRubbish_ = false;  // a prompt came by itself behind what has no end
  Time last_{};
  std::deque<std::string> messages_;
};

}  // namespace vantage
