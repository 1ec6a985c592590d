#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>

#include "base/progress.h"

namespace vantage {

/// What a scan goes through (Pito 1999, Table 2), in the order in which a step runs it.
enum class Phase : std::uint8_t { Scan, Register, Integrate, VoidPatches, ProjectVoid, ProjectSeen, Choose };
inline constexpr int kPhases = 7;

/// "scan", "register", "integrate", "void_patches", "project_void", "project_seen", "choose": also the names of the
/// steps that progress reports.
[[nodiscard]] std::string_view name(Phase phase);

/// The phase of that name, if there is one.
[[nodiscard]] std::optional<Phase> phaseNamed(std::string_view code);

/// Seconds per phase of one step. For reports only: no result depends on it.
using PhaseTimes = std::map<Phase, double>;

/// Measures how long the phases of a progress run. A phase lasts from the first report of its name to that of the next;
/// steps of other names are parts of the phase that they interrupt.
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
