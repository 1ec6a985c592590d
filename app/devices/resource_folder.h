#pragma once

#include <string>

namespace vantage {

/// A folder of what the programs bring along: "turntables", "scanners". Looked for in the folder that the environment
/// variable VANTAGE_RESOURCES names; without it in ../share/vantage beside the program, where an installation puts it;
/// else in the source tree. The folder need not exist.
[[nodiscard]] std::string resourceFolder(const std::string& name);

}  // namespace vantage
