#pragma once

#include <QString>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// "about 20 s", "about 3 min": as exact as an estimate is.
[[nodiscard]] QString durationText(double seconds);

/// How many more views are to come and how long they take, said as the estimate that it is; empty where nobody knows.
[[nodiscard]] QString outlookText(const AcquisitionState& state);

}  // namespace vantage
