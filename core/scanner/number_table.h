#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// A table of numbers, row by row.
struct NumberTable {
  std::size_t columns = 0;
  std::vector<double> values;

  [[nodiscard]] std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
  [[nodiscard]] std::span<const double> row(std::size_t i) const { return {values.data() + i * columns, columns}; }
};

/// Reads lines of numbers divided by commas, semicolons or blanks. Blank lines, lines that begin with # and a first
/// line without a single number (a header) are skipped.
/// @param file named in messages, as the profile names it: what is in one outside of the profile's folder is not
/// quoted.
/// @throws InvalidInput that names file and line when a field is no finite number, when lines differ in length, or for
/// more rows or columns than the limits.
[[nodiscard]] NumberTable parseNumberTable(std::string_view text, const std::string& file, std::size_t maxRows,
                                           std::size_t maxColumns);

}  // namespace vantage
