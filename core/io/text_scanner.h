#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vantage {

/// Walks over a text file field by field and knows the line it is in. Lines end with LF, CR LF or CR; fields are
/// separated by blanks. Views point into the text.
class TextScanner {
 public:
  /// @param firstLine number of the line at which `text` begins.
  TextScanner(std::string_view text, std::string path, std::size_t firstLine = 1);

  /// The next field on the current line; empty at its end.
  [[nodiscard]] std::string_view fieldOnLine();
  /// The next field, on whatever line; empty at the end of the text.
  [[nodiscard]] std::string_view field();
  /// What is left of the current line. The scanner stays where it is.
  [[nodiscard]] std::string_view restOfLine() const;
  /// Goes to the beginning of the next line; false at the end of the text.
  bool nextLine();

  /// Numbers that must come next, on whatever line. @throws InvalidInput naming file, line, value and `what`.
  [[nodiscard]] double number(std::string_view what);
  [[nodiscard]] std::int64_t integer(std::string_view what);

  [[nodiscard]] std::size_t line() const { return line_; }

  /// @throws InvalidInput always: "path: line N: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void skipBlanks();

  const char* at_;
  const char* end_;
  std::size_t line_;
  std::string path_;
};

/// A decimal number, leading + allowed; nothing when the field is anything else. "nan" and "inf" are numbers.
[[nodiscard]] std::optional<double> parseNumber(std::string_view field);
/// The same, where the decimal sign may be a comma as well.
[[nodiscard]] std::optional<double> parseDecimal(std::string_view field);
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view field);

/// A piece of a file as it can stand in a message: at most 40 characters, in quotes, '?' for what cannot be printed.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// ASCII letters in lower case.
[[nodiscard]] std::string lowerCase(std::string_view text);

}  // namespace vantage
