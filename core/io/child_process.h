#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "base/progress.h"

namespace vantage {

struct ChildLimits {
  double cpuSeconds = 5.0;
  double wallSeconds = 30.0;
  std::uintmax_t memoryBytes = 1ULL << 30;  ///< beyond what the calling process has already
};

enum class ChildEnd { Finished, Crashed, OutOfTime, OutOfMemory };

struct ChildResult {
  ChildEnd end = ChildEnd::Finished;
  std::string output;  ///< what the child sent; complete only when it finished
};

/// Hands bytes to the calling process.
using ChildSend = std::function<void(const void* data, std::size_t bytes)>;

/// Runs code that cannot be trusted with our memory in a forked child: it may crash, loop or eat memory there, and only
/// its result is lost. The child is silent (its stdout and stderr go nowhere), may not outlive us and runs `work`
/// alone, without any of our other threads: it must not wait for one of them. Limits are CPU time, address space and,
/// because sanitizers need more address space than any limit, resident memory as watched from outside.
/// @throws IoError when no child can be made
/// @throws Cancelled after the child was stopped
[[nodiscard]] ChildResult runInChild(const std::function<void(const ChildSend&)>& work, const ChildLimits& limits,
                                     const Progress& progress = {});

}  // namespace vantage
