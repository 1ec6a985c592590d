#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

namespace vantage {

/// What a running operation is handed: where to report, whether to stop and how many threads it may use. A cheap value;
/// parts of it share the stop token and the thread count. A default constructed Progress reports nowhere, never stops
/// and runs on one thread.
///
/// `checkpoint` may be called from any thread; the report function is called from whichever thread calls it.
class Progress {
 public:
  /// Receives the overall fraction in [0, 1] and the name of the running step.
  using Report = std::function<void(double fraction, std::string_view step)>;

  Progress() = default;
  Progress(Report report, std::stop_token stop, int threads);

  /// The part of this progress between two fractions of it, named `step` (an empty name keeps the current one).
  [[nodiscard]] Progress part(double from, double to, std::string_view step = {}) const;

  /// The same progress, restricted to `threads` threads.
  [[nodiscard]] Progress withThreads(int threads) const;

  /// The same progress, whose reports go to `observer` as well (before its own).
  [[nodiscard]] Progress observedBy(Report observer) const;

  /// Reports the fraction [0, 1] done of this part. @throws Cancelled when a stop was requested.
  void checkpoint(double fraction) const;

  [[nodiscard]] bool stopRequested() const { return stop_.stop_requested(); }

  /// How many threads the operation may use, at least 1. Results never depend on it.
  [[nodiscard]] int threads() const { return threads_; }

 private:
  std::shared_ptr<const Report> report_;
  std::stop_token stop_;
  int threads_ = 1;
  double from_ = 0.0;
  double to_ = 1.0;
  std::string step_;
};

}  // namespace vantage
