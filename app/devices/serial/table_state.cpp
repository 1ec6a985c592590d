#include "devices/serial/table_state.h"

#include <array>

namespace vantage {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(kLastTableState) + 1> kNames{
    "closed", "idle", "moving", "homing", "held", "door", "alarm", "check", "sleep", "unknown"};

}  // namespace

std::string_view name(TableState state) {
  return kNames.at(static_cast<std::size_t>(state));
}

std::optional<TableState> tableStateOf(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<TableState>(i);
  return std::nullopt;
}

}  // namespace vantage
