#pragma once

#include <optional>
#include <vector>

#include "scanner/scan_reading.h"
#include "session/session.h"

namespace vantage {

/// Remarks in a session which scans are about to be imported, before the first of them is kept.
void noteImport(Session& session, const std::vector<ScanReading>& readings);

/// The import that was interrupted after its scans were kept: nothing when there was none, or it has been carried out.
/// @throws InvalidInput when it was interrupted before all of its scans were kept: they must be imported once more
[[nodiscard]] std::optional<ImportScans> interruptedImport(const Session& session);

}  // namespace vantage
