#include "acquisition/phase_times.h"

namespace vantage {

struct PhaseTimer::Clock {
  std::mutex mutex;
  PhaseTimes seconds;
  std::string phase;
  std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();

  void enter(std::string_view next) {
    const std::lock_guard lock(mutex);
    if (next == phase) return;
    const auto now = std::chrono::steady_clock::now();
    if (!phase.empty()) seconds[phase] += std::chrono::duration<double>(now - since).count();
    phase = next;
    since = now;
  }
};

PhaseTimer::PhaseTimer() : clock_(std::make_shared<Clock>()) {}

Progress PhaseTimer::watch(const Progress& progress) {
  return progress.observedBy([clock = clock_](double /*fraction*/, std::string_view step) { clock->enter(step); });
}

PhaseTimes PhaseTimer::finish() {
  clock_->enter({});
  return clock_->seconds;
}

}  // namespace vantage
