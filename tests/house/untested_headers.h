#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage::testing {

/// Checks that the floors on which everything above stands are tested themselves and not only by what uses them: every
/// header of core/planning, core/acquisition and core/session is included by a `_test.cpp` of the folder in tests/core
/// that is called as its room.
/// @param root folder that holds core/ and tests/; a missing room has nothing to check.
/// @return the headers that none includes, "core/room/header.h", in order of path.
[[nodiscard]] std::vector<std::string> untestedHeaders(const std::filesystem::path& root);

}  // namespace vantage::testing
