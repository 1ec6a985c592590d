#pragma once

#include "acquisition/scan_source.h"
#include "session/session.h"

namespace vantage {

/// Scans of a device that are in the session before anything is made of them. A scan that an interrupted run left there
/// is handed out first, if it was taken from the position asked for. Both must outlive it.
[[nodiscard]] ScanSource keptScans(ScannerDevice& scanner, Session& session);

}  // namespace vantage
