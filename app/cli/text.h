#pragma once

#include <cstddef>
#include <string>

namespace vantage {

/// A number with a fixed count of decimals.
[[nodiscard]] std::string number(double value, int decimals);

/// How many of what: "1 opening", "3 openings".
/// @param plural the noun when there is not exactly one; empty: the noun with an s
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun, const std::string& plural = "");

/// Writes a text file whole or not at all. @throws IoError
void writeTextFile(const std::string& path, const std::string& text);

}  // namespace vantage
