#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "scanner/turntable.h"

namespace vantage {

/// What a table on a serial line says that it does.
enum class TableState : std::uint8_t {
  Closed,   ///< not connected
  Idle,     ///< at rest and ready
  Moving,   ///< turning
  Homing,   ///< looking for its index
  Held,     ///< stopped in a move that is not over
  Door,     ///< a safety door is open
  Alarm,    ///< locked
  Check,    ///< obeys nothing, only checks commands
  Sleep,    ///< switched off its motors
  Unknown,  ///< does not say
};
inline constexpr TableState kLastTableState = TableState::Unknown;
/// "closed", "idle", "moving", ...
[[nodiscard]] std::string_view name(TableState state);
/// The inverse of name; nothing for other words.
[[nodiscard]] std::optional<TableState> tableStateOf(std::string_view name);

/// A table as a window shows it.
struct TableStatus {
  TableState state = TableState::Closed;
  std::optional<TableAngle> angle;  ///< nothing when it is not known
};

}  // namespace vantage
