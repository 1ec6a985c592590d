#pragma once

#include <cstdint>
#include <vector>

#include "acquisition/history.h"
#include "session/database.h"
#include "session/loss.h"

namespace vantage {

/// The history that a file tells, as far as it is readable.
struct StoredHistory {
  std::vector<HistoryEntry> entries;
  std::size_t cursor = 0;
  std::vector<Loss> losses;  ///< everything that is not
};

/// The steps that lead to `tip`, from the tables step, record and view. What is damaged is left out and named.
[[nodiscard]] StoredHistory readHistory(Database& database, std::int64_t tip, std::int64_t cursor);

/// Where a row says that its scan was taken: the columns `column` (stand) and `column` + 1 (position, or NULL).
[[nodiscard]] Station stationOf(const Statement& row, int column);

}  // namespace vantage
