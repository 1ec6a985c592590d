#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Reads one object of a JSON document field by field. Every error names file, JSON pointer, value and what was expected;
/// `finish` refuses fields that nobody asked for.
class JsonObjectReader {
 public:
  /// @throws InvalidInput when `value` is not an object.
  JsonObjectReader(const nlohmann::json& value, std::string file, std::string pointer);

  [[nodiscard]] bool has(const std::string& key) const { return value_.contains(key); }

  /// A number in [low, high]; with `open` the ends do not belong to it.
  [[nodiscard]] double number(const std::string& key, double low, double high, bool open = false);
  [[nodiscard]] double number(const std::string& key, double low, double high, bool open, double fallback);
  [[nodiscard]] int integer(const std::string& key, int low, int high);
  [[nodiscard]] std::string string(const std::string& key);
  [[nodiscard]] Vec3 vector(const std::string& key);
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t least, std::size_t most);
  [[nodiscard]] std::vector<Vec3> vectors(const std::string& key, std::size_t most);
  [[nodiscard]] JsonObjectReader object(const std::string& key);
  [[nodiscard]] const nlohmann::json& required(const std::string& key, std::string_view expected);

  /// @throws InvalidInput for a field that was not read.
  void finish() const;

  /// @throws InvalidInput always: the field's value is not what was expected.
  [[noreturn]] void fail(const std::string& key, std::string_view expected) const;

 private:
  [[nodiscard]] double checkedNumber(const nlohmann::json& v, const std::string& key, std::string_view expected) const;

  const nlohmann::json& value_;
  std::string file_;
  std::string pointer_;
  std::set<std::string> read_;
};

}  // namespace vantage
