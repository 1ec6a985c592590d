#pragma once

#include <QString>

#include "finishing/finished_model.h"

namespace vantage {

/// Why a model cannot be printed as one piece, one line for every reason; empty when it can.
[[nodiscard]] QString whyNotPrintable(const PrintCheck& check);

/// What was done to a model before it was written, a line each.
[[nodiscard]] QString finishingText(const FinishedModel& finished);

}  // namespace vantage
