#include "session/json_fields.h"

#include <cmath>

namespace vantage {
namespace {

constexpr int kMaxDepth = 16;

}  // namespace

nlohmann::json jsonNumber(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json jsonObject(const std::string& text, const std::string& what) {
  const auto notTooDeep = [&](int depth, nlohmann::json::parse_event_t /*event*/, nlohmann::json& /*value*/) {
    if (depth > kMaxDepth) throw InvalidInput(what + " is damaged: it is nested too deep");
    return true;
  };
  try {
    nlohmann::json json = nlohmann::json::parse(text, notTooDeep);
    if (json.is_object()) return json;
  } catch (const nlohmann::json::exception&) {
    // Said below.
  }
  throw InvalidInput(what + " is damaged: it is no JSON object");
}

JsonFields::JsonFields(const nlohmann::json& json, std::string what) : json_(json), what_(std::move(what)) {
  if (!json.is_object()) throw InvalidInput(what_ + " is damaged: it is no JSON object");
}

void JsonFields::fail(const char* key) const {
  throw InvalidInput(what_ + " is damaged: its field " + key + " is missing or has no possible value");
}

const nlohmann::json& JsonFields::at(const char* key) const {
  const auto it = json_.find(key);
  if (it == json_.end()) fail(key);
  return *it;
}

bool JsonFields::has(const char* key) const {
  return json_.contains(key);
}

bool JsonFields::isText(const char* key) const {
  return at(key).is_string();
}

double JsonFields::number(const char* key) const {
  const nlohmann::json& value = at(key);
  if (value.is_null()) return std::numeric_limits<double>::infinity();
  if (!value.is_number()) fail(key);
  return value.get<double>();
}

std::int64_t JsonFields::integer(const char* key, std::int64_t low, std::int64_t high) const {
  const nlohmann::json& value = at(key);
  const bool tooLarge = value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(high);
  if (!value.is_number_integer() || tooLarge) fail(key);
  const auto result = value.get<std::int64_t>();
  if (result < low || result > high) fail(key);
  return result;
}

int JsonFields::integer(const char* key) const {
  return static_cast<int>(integer(key, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

std::size_t JsonFields::count(const char* key) const {
  return static_cast<std::size_t>(integer(key, 0, std::numeric_limits<std::int64_t>::max()));
}

bool JsonFields::flag(const char* key) const {
  const nlohmann::json& value = at(key);
  if (!value.is_boolean()) fail(key);
  return value.get<bool>();
}

std::string JsonFields::text(const char* key) const {
  const nlohmann::json& value = at(key);
  if (!value.is_string()) fail(key);
  return value.get<std::string>();
}

const nlohmann::json& JsonFields::list(const char* key) const {
  const nlohmann::json& value = at(key);
  if (!value.is_array()) fail(key);
  return value;
}

JsonFields JsonFields::object(const char* key) const {
  return {at(key), what_};
}

void JsonFields::numbers(const char* key, double* values, std::size_t count) const {
  const nlohmann::json& items = list(key);
  if (items.size() != count) fail(key);
  for (std::size_t i = 0; i < count; ++i) {
    if (!items[i].is_number() && !items[i].is_null()) fail(key);
    values[i] = items[i].is_null() ? std::numeric_limits<double>::infinity() : items[i].get<double>();
  }
}

}  // namespace vantage
