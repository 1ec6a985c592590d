#pragma once

#include <string_view>

namespace vantage {

enum class LogLevel { Debug, Info, Warning, Error };

/// Where an operation says what it noticed. Handed down, never global; `LogSink::none()` swallows everything.
class LogSink {
 public:
  virtual ~LogSink() = default;
  /// May be called from any thread.
  virtual void write(LogLevel level, std::string_view message) = 0;
  /// A sink without a state that drops what it gets.
  [[nodiscard]] static LogSink& none();
};

}  // namespace vantage
