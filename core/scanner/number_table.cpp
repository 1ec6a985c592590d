#include "scanner/number_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/errors.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

constexpr std::string_view kDividers = ",; \t\r";

// Takes the first piece up to a divider off the text.
std::string_view takePiece(std::string_view& text, std::string_view dividers) {
  const std::size_t end = std::min(text.find_first_of(dividers), text.size());
  const std::string_view piece = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return piece;
}

std::optional<double> parseNumber(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Appends the line's numbers and gives back how many; stops at a field that is none and hands it out.
std::size_t appendNumbers(std::string_view line, std::size_t most, std::vector<double>& values,
                          std::string_view& notANumber) {
  std::size_t count = 0;
  while (!line.empty() && count <= most) {
    const std::string_view field = takePiece(line, kDividers);
    if (field.empty()) continue;
    const auto value = parseNumber(field);
    if (!value) {
      notANumber = field;
      return count;
    }
    values.push_back(*value);
    ++count;
  }
  return count;
}

// What a profile names outside of its folder may be any file: messages say nothing of what is in it.
bool mayBeQuoted(const std::filesystem::path& file) {
  return file.is_relative() && std::find(file.begin(), file.end(), "..") == file.end();
}

bool hasNumber(std::string_view line) {
  while (!line.empty())
    if (parseNumber(takePiece(line, kDividers))) return true;
  return false;
}

}  // namespace

NumberTable parseNumberTable(std::string_view text, const std::string& file, std::size_t maxRows,
                             std::size_t maxColumns) {
  NumberTable table;
  bool first = true;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = takePiece(text, "\n");
    const std::size_t start = line.find_first_not_of(kDividers);
    if (start == std::string_view::npos || line[start] == '#') continue;
    const bool header = first && !hasNumber(line);
    first = false;
    if (header) continue;

    const std::string where = file + ": line " + std::to_string(number) + " has ";
    std::string_view notANumber;
    const std::size_t count = appendNumbers(line, maxColumns, table.values, notANumber);
    if (!notANumber.empty())
      throw InvalidInput(where + (mayBeQuoted(file) ? shownText(notANumber) : "a field that is none") +
                         ", expected a finite number");
    if (count > maxColumns)
      throw InvalidInput(where + "more than " + std::to_string(maxColumns) + " numbers, expected no more");
    if (table.columns == 0) table.columns = count;
    if (count != table.columns)
      throw InvalidInput(where + std::to_string(count) + " numbers, expected " + std::to_string(table.columns) +
                         " as in the lines before");
    if (table.rows() > maxRows)
      throw InvalidInput(where + "row " + std::to_string(table.rows()) + ", expected no more than " +
                         std::to_string(maxRows));
  }
  return table;
}

}  // namespace vantage
