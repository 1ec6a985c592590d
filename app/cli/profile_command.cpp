#include "cli/command.h"

namespace vantage {

void addProfileCommand(CLI::App& /*app*/, CommandContext& /*context*/) {}

}  // namespace vantage
