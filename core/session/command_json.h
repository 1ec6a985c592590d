#pragma once

#include <string>
#include <string_view>

#include "acquisition/command.h"

namespace vantage {

/// What a command says beyond its kind (see kindOf), as JSON text.
[[nodiscard]] std::string commandText(const Command& command);
/// @throws InvalidInput naming `what` when the kind is not known or the text is no such command.
[[nodiscard]] Command commandFromText(std::string_view kind, const std::string& text, const std::string& what);

}  // namespace vantage
