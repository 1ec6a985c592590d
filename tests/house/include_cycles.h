#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage::testing {

/// Headers of core, widgets and app that include each other in a circle: each shortest circle once, as the headers on
/// it from the first in the alphabet back to itself, "core/io/a.h > core/io/b.h > core/io/a.h".
[[nodiscard]] std::vector<std::string> includeCycles(const std::filesystem::path& root);

}  // namespace vantage::testing
