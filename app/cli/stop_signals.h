#pragma once

#include <stop_token>
#include <thread>

namespace vantage {

/// While it lives, SIGINT, SIGTERM and SIGHUP request a stop instead of ending the program, and what cannot be written
/// is an error of writing, no signal. Make it before any other thread, so that all of them inherit the blocked signals.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread waiter_;
};

}  // namespace vantage
