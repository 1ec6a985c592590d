#pragma once

#include <functional>

#include "cli/command.h"

namespace vantage {

/// Reads the arguments of a program of the command line, carries out the command that they name, and says on stderr
/// what went wrong. Until it ends SIGINT, SIGTERM and SIGHUP cancel the command.
/// @param addCommands adds the commands that the program knows
/// @return exit code of the contract: 0 done, 1 failed, 2 wrong use, 3 cancelled, 4 done, but not all is well
int runCommandLine(int argc, char** argv, const std::function<void(CLI::App&, CommandContext&)>& addCommands);

}  // namespace vantage
