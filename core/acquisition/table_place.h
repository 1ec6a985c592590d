#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "acquisition/journal.h"
#include "scanner/table_stand.h"

namespace vantage {

/// How far a pose turns about the z axis [rad].
[[nodiscard]] double turnAboutAxis(const Pose& turn);

/// How much farther round the axis than its table says the last scan was found [rad, counter-clockwise from above],
/// because the table slipped, was pushed or lost its place; nothing where nothing of the kind is known of it.
[[nodiscard]] std::optional<double> slipOfLastScan(const AcquisitionState& state);

/// The scans that were found where the table would have turned the other way than it says, by number.
[[nodiscard]] std::vector<std::int64_t> scansTurnedBack(const AcquisitionState& state);

/// Where the table stands: at the position of the scan that was taken last in the stand of now, whatever became of it;
/// at the first position of the workspace before that. What scans have shown of a slip counts from there on.
/// Nothing when scans have no positions.
[[nodiscard]] std::optional<TableStand> tableStand(const Journal& journal);

/// Its position alone.
[[nodiscard]] std::optional<int> tablePosition(const Journal& journal);

}  // namespace vantage
