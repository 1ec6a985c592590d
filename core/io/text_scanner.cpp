#include "io/text_scanner.h"

#include <charconv>
#include <limits>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// from_chars knows no leading plus sign.
std::string_view withoutPlus(std::string_view field) {
  if (field.size() > 1 && field[0] == '+' && field[1] != '-' && field[1] != '+') field.remove_prefix(1);
  return field;
}

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string path, std::size_t firstLine)
    : at_(text.data()), end_(text.data() + text.size()), line_(firstLine), path_(std::move(path)) {}

void TextScanner::skipBlanks() {
  while (at_ != end_ && isBlank(*at_)) ++at_;
}

std::string_view TextScanner::fieldOnLine() {
  skipBlanks();
  const char* begin = at_;
  while (at_ != end_ && !isBlank(*at_) && !isLineEnd(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextScanner::field() {
  for (;;) {
    const std::string_view found = fieldOnLine();
    if (!found.empty() || !nextLine()) return found;
  }
}

std::string_view TextScanner::restOfLine() const {
  const char* stop = at_;
  while (stop != end_ && !isLineEnd(*stop)) ++stop;
  return {at_, static_cast<std::size_t>(stop - at_)};
}

bool TextScanner::nextLine() {
  while (at_ != end_ && !isLineEnd(*at_)) ++at_;
  if (at_ == end_) return false;
  const char first = *at_++;
  if (first == '\r' && at_ != end_ && *at_ == '\n') ++at_;
  ++line_;
  return at_ != end_;
}

double TextScanner::number(std::string_view what) {
  const std::string_view text = field();
  const auto value = parseDecimal(text);
  if (value) return *value;
  if (text.empty()) fail("the file ends, expected " + std::string(what));
  fail(inQuotes(text) + " is not a number, expected " + std::string(what));
}

std::int64_t TextScanner::integer(std::string_view what) {
  const std::string_view text = field();
  const auto value = parseInteger(text);
  if (value) return *value;
  if (text.empty()) fail("the file ends, expected " + std::string(what));
  fail(inQuotes(text) + " is not a whole number, expected " + std::string(what));
}

void TextScanner::fail(const std::string& what) const {
  throw InvalidInput(path_ + ": line " + std::to_string(line_) + ": " + what);
}

std::optional<double> parseNumber(std::string_view field) {
  field = withoutPlus(field);
  double value = 0.0;
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  if (result.ptr != field.data() + field.size() || field.empty()) return std::nullopt;
  if (result.ec == std::errc::result_out_of_range) {
    // Too small for a double is zero, too large is infinite.
    const bool tiny = field.find("e-") != std::string_view::npos || field.find("E-") != std::string_view::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (result.ec != std::errc()) return std::nullopt;
  return value;
}

std::optional<double> parseDecimal(std::string_view field) {
  constexpr std::size_t kMost = 64;  // characters of a number with a comma
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos || field.size() > kMost || field.find('.') != std::string_view::npos)
    return parseNumber(field);
  std::string text(field);
  text[comma] = '.';
  return parseNumber(text);
}

std::optional<std::int64_t> parseInteger(std::string_view field) {
  field = withoutPlus(field);
  std::int64_t value = 0;
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  if (result.ec != std::errc() || result.ptr != field.data() + field.size()) return std::nullopt;
  return value;
}

std::string inQuotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, 40))
    result += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? '?' : c;
  return result + (text.size() > 40 ? "...'" : "'");
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace vantage
