#pragma once

#include <string_view>
#include <variant>

#include "acquisition/course_commands.h"
#include "acquisition/erase_commands.h"
#include "acquisition/scan_commands.h"
#include "acquisition/stand_commands.h"

namespace vantage {

/// One variant of the kinds of several.
template <typename... Groups>
struct Joined;
template <typename... First, typename... Second, typename... Groups>
struct Joined<std::variant<First...>, std::variant<Second...>, Groups...>
    : Joined<std::variant<First..., Second...>, Groups...> {};
template <typename... Kinds>
struct Joined<std::variant<Kinds...>> {
  using Type = std::variant<Kinds...>;
};

/// Everything that an operator or an automatic run does to a session. Undo and redo move between the results.
///
/// Every command is a struct that says
/// - `kKind`: how the session file names it;
/// - `fields(self, field)`: calls field(name, member) for everything that the session file keeps of it;
/// - `mayDo(state)`: why it cannot be carried out on a state; nothing when it can;
/// - `carriedOut(state, tools)`: the state it leads to. @pre it may be done. @throws InvalidInput, Cancelled
using Command = Joined<CourseCommand, ScanCommand, StandCommand, EraseCommand>::Type;

/// "change_settings", "add_scan", ...: how the session file names a command's kind.
[[nodiscard]] std::string_view kindOf(const Command& command);

}  // namespace vantage
