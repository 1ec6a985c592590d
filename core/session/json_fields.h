#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/errors.h"

namespace vantage {

/// Reads fields of a JSON object that is not to be trusted. @throws InvalidInput naming what is damaged and the field.
class JsonFields {
 public:
  /// @param json must outlive the reader.
  JsonFields(const nlohmann::json& json, std::string what);

  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] bool isText(const char* key) const;
  /// null is infinity.
  [[nodiscard]] double number(const char* key) const;
  [[nodiscard]] std::int64_t integer(const char* key, std::int64_t low, std::int64_t high) const;
  [[nodiscard]] int integer(const char* key) const;
  [[nodiscard]] std::size_t count(const char* key) const;
  [[nodiscard]] bool flag(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] const nlohmann::json& list(const char* key) const;
  [[nodiscard]] JsonFields object(const char* key) const;
  /// A list of `count` numbers.
  void numbers(const char* key, double* values, std::size_t count) const;
  /// An enumerator by its name; `Last` is the greatest.
  template <typename Enum>
  [[nodiscard]] Enum named(const char* key, Enum last) const {
    const std::string wanted = text(key);
    for (int i = 0; i <= static_cast<int>(last); ++i)
      if (name(static_cast<Enum>(i)) == wanted) return static_cast<Enum>(i);
    fail(key);
  }
  [[noreturn]] void fail(const char* key) const;
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  [[nodiscard]] const nlohmann::json& at(const char* key) const;

  const nlohmann::json& json_;
  std::string what_;
};

/// A number for JSON, which has no infinity: null.
[[nodiscard]] nlohmann::json jsonNumber(double value);

/// @throws InvalidInput naming `what` when the text is no JSON object, or nested deeper than ours are.
[[nodiscard]] nlohmann::json jsonObject(const std::string& text, const std::string& what);

}  // namespace vantage
