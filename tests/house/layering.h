#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage::testing {

/// Checks that the source tree keeps the rules of the house:
/// - app includes widgets and core, widgets include core, core includes neither;
/// - a room of core includes only rooms that stand before it;
/// - core has no Qt, no VTK, no stream or printf output and no std::random;
/// - a heavy dependency has one door.
/// @param root folder that holds core/, widgets/ and app/; a missing one has nothing to check.
/// @return one line for every violation, "file:line: why", in order of path.
[[nodiscard]] std::vector<std::string> layeringViolations(const std::filesystem::path& root);

}  // namespace vantage::testing
