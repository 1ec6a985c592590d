#pragma once

#include "scanner/profile.h"

namespace vantage::testing {

/// A head at x = 300 looking along -x over a 200 mm square around z = 100, receiver 60 mm to its right (toward +y),
/// breakdown angle 60 degrees, a turntable of four steps.
[[nodiscard]] ScannerProfile flatScanner();

}  // namespace vantage::testing
