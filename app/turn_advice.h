#pragma once

#include <optional>

#include "scanner/profile.h"
#include "scanner/table_turn.h"

namespace vantage {

/// How an operator turns the table from where it stands to another position.
struct TurnAdvice {
  double from = 0.0;  ///< azimuth of the scanner about the object, counter-clockwise from +x [rad]
  double to = 0.0;    ///< the same of the other position [rad]
  TableTurn turn;
};

/// Nothing without a turntable or for a position that there is not.
[[nodiscard]] std::optional<TurnAdvice> adviseTurn(const ScannerProfile& profile, std::optional<int> from, int to);

}  // namespace vantage
