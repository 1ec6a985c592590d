#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage::testing {

/// Functions that are declared in a header of core and defined in a source of another name, "file:line: name is
/// declared in header". What x.h declares is defined in x.cpp, or in x_<part>.cpp where that would be too long. Names
/// that several headers of a room declare may be defined beside any of them.
[[nodiscard]] std::vector<std::string> strayDefinitions(const std::filesystem::path& root);

}  // namespace vantage::testing
