#include "scanner/profile_reader.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

// A value as it stands in the file, cut to what fits a message.
std::string shown(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

std::string compact(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

JsonObjectReader::JsonObjectReader(const nlohmann::json& value, std::string file, std::string pointer)
    : value_(value), file_(std::move(file)), pointer_(std::move(pointer)) {
  if (!value_.is_object())
    throw InvalidInput(file_ + ": " + (pointer_.empty() ? "/" : pointer_) + " is " + shown(value_) + ", expected an object");
}

void JsonObjectReader::fail(const std::string& key, std::string_view expected) const {
  throw InvalidInput(file_ + ": " + pointer_ + "/" + key + " is " + shown(value_.at(key)) + ", expected " +
                     std::string(expected));
}

const nlohmann::json& JsonObjectReader::required(const std::string& key, std::string_view expected) {
  read_.insert(key);
  const auto it = value_.find(key);
  if (it == value_.end())
    throw InvalidInput(file_ + ": " + pointer_ + "/" + key + " is missing, expected " + std::string(expected));
  return *it;
}

double JsonObjectReader::checkedNumber(const nlohmann::json& v, const std::string& key, std::string_view expected) const {
  if (!v.is_number() || !std::isfinite(v.get<double>())) fail(key, expected);
  return v.get<double>();
}

double JsonObjectReader::number(const std::string& key, double low, double high, bool open) {
  const std::string expected = std::string("a number ") + (open ? "between " : "from ") + compact(low) +
                               (open ? " and " : " to ") + compact(high);
  const double value = checkedNumber(required(key, expected), key, expected);
  if (open ? value <= low || value >= high : value < low || value > high) fail(key, expected);
  return value;
}

double JsonObjectReader::number(const std::string& key, double low, double high, bool open, double fallback) {
  return has(key) ? number(key, low, high, open) : fallback;
}

int JsonObjectReader::integer(const std::string& key, int low, int high) {
  const std::string expected = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  const double value = checkedNumber(required(key, expected), key, expected);
  if (value != std::floor(value) || value < low || value > high) fail(key, expected);
  return static_cast<int>(value);
}

std::string JsonObjectReader::string(const std::string& key) {
  const nlohmann::json& v = required(key, "a text");
  if (!v.is_string() || v.get_ref<const std::string&>().empty()) fail(key, "a text that is not empty");
  return v.get<std::string>();
}

std::vector<double> JsonObjectReader::numbers(const std::string& key, std::size_t least, std::size_t most) {
  const std::string expected = "a list of " + std::to_string(least) +
                               (most == least ? "" : " to " + std::to_string(most)) + " numbers";
  const nlohmann::json& v = required(key, expected);
  if (!v.is_array() || v.size() < least || v.size() > most) fail(key, expected);
  std::vector<double> result;
  result.reserve(v.size());
  for (const auto& item : v) result.push_back(checkedNumber(item, key, expected));
  return result;
}

Vec3 JsonObjectReader::vector(const std::string& key) {
  const auto v = numbers(key, 3, 3);
  if (Vec3(v[0], v[1], v[2]).cwiseAbs().maxCoeff() > 1e5) fail(key, "coordinates within 100000 mm");
  return {v[0], v[1], v[2]};
}

std::vector<Vec3> JsonObjectReader::vectors(const std::string& key, std::size_t most) {
  const std::string expected = "a list of at most " + std::to_string(most) + " triples of numbers";
  const nlohmann::json& v = required(key, expected);
  if (!v.is_array() || v.size() > most) fail(key, expected);
  std::vector<Vec3> result;
  for (const auto& item : v) {
    if (!item.is_array() || item.size() != 3) fail(key, expected);
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) p[static_cast<Eigen::Index>(k)] = checkedNumber(item[k], key, expected);
    result.push_back(p);
  }
  return result;
}

JsonObjectReader JsonObjectReader::object(const std::string& key) {
  return {required(key, "an object"), file_, pointer_ + "/" + key};
}

void JsonObjectReader::finish() const {
  for (const auto& [key, value] : value_.items()) {
    if (read_.contains(key)) continue;
    std::string known;
    for (const std::string& k : read_) known += (known.empty() ? "" : ", ") + k;
    throw InvalidInput(file_ + ": " + pointer_ + "/" + key + " is not a known field, expected one of " + known);
  }
}

}  // namespace vantage
