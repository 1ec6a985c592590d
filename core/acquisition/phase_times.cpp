#include "acquisition/phase_times.h"

#include <array>

namespace vantage {
namespace {

constexpr std::array<std::string_view, kPhases> kNames{"scan",         "register",     "integrate", "void_patches",
                                                       "project_void", "project_seen", "choose"};

}  // namespace

std::string_view name(Phase phase) {
  return kNames.at(static_cast<std::size_t>(phase));
}

std::optional<Phase> phaseNamed(std::string_view code) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == code) return static_cast<Phase>(i);
  return std::nullopt;
}

struct PhaseTimer::Clock {
  std::mutex mutex;
  PhaseTimes seconds;
  std::optional<Phase> phase;
  std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();

  void enter(std::optional<Phase> next) {
    const std::lock_guard lock(mutex);
    if (next == phase) return;
    const auto now = std::chrono::steady_clock::now();
    if (phase) seconds[*phase] += std::chrono::duration<double>(now - since).count();
    phase = next;
    since = now;
  }
};

PhaseTimer::PhaseTimer() : clock_(std::make_shared<Clock>()) {}

Progress PhaseTimer::watch(const Progress& progress) {
  return progress.observedBy([clock = clock_](double /*fraction*/, std::string_view step) {
    if (const auto phase = phaseNamed(step)) clock->enter(phase);
  });
}

PhaseTimes PhaseTimer::finish() {
  clock_->enter(std::nullopt);
  return clock_->seconds;
}

}  // namespace vantage
