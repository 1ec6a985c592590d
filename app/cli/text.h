#pragma once

#include <string>

namespace vantage {

/// A number with a fixed count of decimals.
[[nodiscard]] std::string number(double value, int decimals);

/// Writes a text file whole or not at all. @throws IoError
void writeTextFile(const std::string& path, const std::string& text);

}  // namespace vantage
