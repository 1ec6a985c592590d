#pragma once

#include <cstdint>
#include <optional>
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

/// The most steps that are read of a file. A run has some hundred, but a file may come from anywhere.
inline constexpr std::int64_t kMostSteps = 10'000;

/// The first step that is read of a file that has more than kMostSteps; nothing when all of them are.
[[nodiscard]] std::optional<std::int64_t> firstStepRead(Database& database);

/// The steps that lead to `tip`, the last kMostSteps of the file at most, from the tables step, record and view. What
/// is damaged is left out and named.
[[nodiscard]] StoredHistory readHistory(Database& database, std::int64_t tip, std::int64_t cursor);

/// Where a row says that its scan was taken: the columns `column` (stand) and `column` + 1 (position, or NULL).
[[nodiscard]] Station stationOf(const Statement& row, int column);

}  // namespace vantage
