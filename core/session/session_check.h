#pragma once

#include <vector>

#include "base/progress.h"
#include "session/loss.h"
#include "session/session_store.h"

namespace vantage {

/// Everything in a session that is not as it was written: rows by their sums, scans as far as they can be read, files
/// and object that belong together. Reads the whole file, and keeps nothing of it in memory. What an earlier version
/// wrote has no sums: of it only what does not fit together is noticed.
/// @throws Cancelled, IoError when the database fails
[[nodiscard]] std::vector<Loss> checkRows(SessionStore& store, const Progress& progress = {});

}  // namespace vantage
