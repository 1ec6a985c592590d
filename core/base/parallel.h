#pragma once

#include <cstddef>
#include <functional>

#include "base/progress.h"

namespace vantage {

/// Calls `body(begin, end)` for consecutive chunks of `grain` indices that cover [0, count), on up to
/// `progress.threads()` threads. The chunks depend only on `count` and `grain`, never on the number of threads: a body
/// that writes to places owned by its indices, or to one slot per chunk that is reduced in order afterwards, gives the
/// same bytes for any number of threads.
///
/// The calling thread takes part. The progress is checked between chunks.
/// @throws Cancelled, and whatever the body throws (that of the lowest chunk among those that ran).
void parallelChunks(std::size_t count, std::size_t grain, const Progress& progress,
                    const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace vantage
