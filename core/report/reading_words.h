#pragma once

#include "base/phrase.h"
#include "scanner/scan_reading.h"

namespace vantage {

/// As what a recorded scan was read, and why: "1 unit = 1000 mm (as the numbers tell), the scanner looks along +z (as
/// the numbers tell), 120 cells of (0, 0, 0) left out".
[[nodiscard]] Phrase phraseOf(const ScanReading& reading);

}  // namespace vantage
