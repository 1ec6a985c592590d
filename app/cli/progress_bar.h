#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace vantage {

/// A progress bar on stderr, drawn only when that is a terminal; at most ten times a second.
class ProgressBar {
 public:
  explicit ProgressBar(bool enabled);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws the bar. May be called from any thread.
  void show(double fraction, std::string_view step);
  /// Removes the bar, so that a line can be printed where it stood.
  void clear();

  [[nodiscard]] static bool terminal();

 private:
  bool enabled_;
  bool drawn_ = false;
  std::string step_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace vantage
