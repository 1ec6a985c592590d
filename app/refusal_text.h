#pragma once

#include <QString>

#include "acquisition/refusal.h"

namespace vantage {

/// Why something cannot be done, for the operator.
[[nodiscard]] QString refusalText(const Refusal& refusal);

}  // namespace vantage
