#include "acquisition/command.h"

#include <array>

namespace vantage {
namespace {

std::string described(const ChangeSettings& /*command*/) {
  return "Set-up changed";
}
std::string described(const AddScan& command) {
  return "Scan " + std::to_string(command.scan) + " added";
}
std::string described(const ImportScans& command) {
  return std::to_string(command.scans.size()) + " recorded scans imported";
}
std::string described(const ChoosePosition& command) {
  return command.position < 0 ? "Proposed position taken again"
                              : "Position " + std::to_string(command.position) + " chosen";
}
std::string described(const LeaveOutView& command) {
  return "Scan " + std::to_string(command.scan) + " left out";
}
std::string described(const TakeBackView& command) {
  return "Scan " + std::to_string(command.scan) + " taken back";
}
std::string described(const Finish& command) {
  return command.termination == Termination::Running ? "Opened again"
                                                     : "Ended: " + std::string(name(command.termination));
}
std::string described(const TakeOver& /*command*/) {
  return "Taken over from an earlier version";
}

}  // namespace

std::string_view kindOf(const Command& command) {
  constexpr std::array<std::string_view, std::variant_size_v<Command>> kKinds{
      "change_settings", "add_scan",  "import_scans", "choose_position",
      "leave_out",       "take_back", "finish",       "take_over"};
  return kKinds[command.index()];
}

std::string describe(const Command& command) {
  return std::visit([](const auto& c) { return described(c); }, command);
}

}  // namespace vantage
