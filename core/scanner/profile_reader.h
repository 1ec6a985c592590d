#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Lengths and coordinates farther out than this are refused: no scanner is a hundred metres wide.
inline constexpr double kMaxCoordinate = 1e5;  // [mm]

/// Foreign text for a message: quoted, control characters escaped, cut to what fits.
[[nodiscard]] std::string shownText(std::string_view text);

/// @param file named in messages.
/// @throws InvalidInput when the text is no JSON document, or one that is nested deeper than a profile can be.
[[nodiscard]] nlohmann::json parseJson(const std::string& text, const std::string& file);

/// Reads one object of a JSON document field by field. Every error names file, JSON pointer, value and what was
/// expected; `finish` refuses fields that nobody asked for. The document outlives the reader.
class JsonObjectReader {
 public:
  /// @throws InvalidInput when `value` is not an object.
  JsonObjectReader(const nlohmann::json& value, std::string file, std::string pointer);

  /// Whether an optional field is there. Asking for it makes it a known field.
  [[nodiscard]] bool has(const std::string& key);

  /// A number in [low, high]; with `open` the ends do not belong to it.
  [[nodiscard]] double number(const std::string& key, double low, double high, bool open = false);
  [[nodiscard]] double number(const std::string& key, double low, double high, bool open, double fallback);
  [[nodiscard]] int integer(const std::string& key, int low, int high);
  [[nodiscard]] std::string string(const std::string& key);
  /// The name of a file: a text without control characters.
  [[nodiscard]] std::string fileName(const std::string& key);
  /// A point [mm] within kMaxCoordinate.
  [[nodiscard]] Vec3 vector(const std::string& key);
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t least, std::size_t most);
  /// Points [mm] within kMaxCoordinate.
  [[nodiscard]] std::vector<Vec3> vectors(const std::string& key, std::size_t most);
  [[nodiscard]] JsonObjectReader object(const std::string& key);
  [[nodiscard]] const nlohmann::json& required(const std::string& key, std::string_view expected);

  /// @throws InvalidInput for a field that was not read.
  void finish() const;

  /// @throws InvalidInput always: the field's value is not what was expected.
  [[noreturn]] void fail(const std::string& key, std::string_view expected) const;

 private:
  /// "file: /pointer/to/key", fit for a message.
  [[nodiscard]] std::string where(const std::string& key) const;
  [[nodiscard]] double checkedNumber(const nlohmann::json& v, const std::string& key, std::string_view expected) const;

  const nlohmann::json& value_;
  std::string file_;
  std::string pointer_;
  std::set<std::string> known_;
};

}  // namespace vantage
