#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage::testing {

/// Variables of headers that begin at -1, "file:line: name": what may be missing is std::optional. Descriptors of files
/// are as the operating system has them, in the two headers that hold one.
[[nodiscard]] std::vector<std::string> missingValues(const std::filesystem::path& root);

}  // namespace vantage::testing
