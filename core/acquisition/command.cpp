#include "acquisition/command.h"

#include <array>

namespace vantage {
std::string_view kindOf(const Command& command) {
  constexpr std::array<std::string_view, std::variant_size_v<Command>> kKinds{
      "change_settings", "add_scan",  "import_scans", "choose_position", "leave_out",  "take_back",
      "finish",          "take_over", "turn_object",  "place_stand",     "change_mode"};
  return kKinds[command.index()];
}

}  // namespace vantage
