#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "base/progress.h"

namespace vantage {

/// Seconds per phase of one step, by the names of the phases (Pito 1999, Table 2). For reports only: no result depends
/// on it.
using PhaseTimes = std::map<std::string, double>;

/// Measures how long the named parts of a progress run. A phase lasts from its first report to that of the next.
class PhaseTimer {
 public:
  PhaseTimer();

  /// The progress to hand to the work; its step names become the phases.
  [[nodiscard]] Progress watch(const Progress& progress);

  /// Ends the running phase and returns the seconds of all.
  [[nodiscard]] PhaseTimes finish();

 private:
  struct Clock;
  std::shared_ptr<Clock> clock_;
};

}  // namespace vantage
