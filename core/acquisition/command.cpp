#include "acquisition/command.h"

namespace vantage {

std::string_view kindOf(const Command& command) {
  return std::visit([](const auto& c) { return c.kKind; }, command);
}

}  // namespace vantage
