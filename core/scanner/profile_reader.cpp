#include "scanner/profile_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

// Profiles nest four deep; a document that goes on for ever would exhaust the stack when shown.
constexpr int kMaxDepth = 16;
// Characters of a value that a message shows.
constexpr std::size_t kShown = 60;

std::string shortened(std::string text) {
  if (text.size() > kShown) text = text.substr(0, kShown - 3) + "...";
  return text;
}

std::string dumped(const nlohmann::json& value) {
  return value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

// A value as it stands in the file.
std::string shown(const nlohmann::json& value) {
  return shortened(dumped(value));
}

// A key as it stands in a JSON pointer (RFC 6901), control characters escaped.
std::string pointerToken(const std::string& key) {
  std::string escaped;
  for (const char ch : key) {
    if (ch == '~') {
      escaped += "~0";
    } else if (ch == '/') {
      escaped += "~1";
    } else {
      escaped += ch;
    }
  }
  const std::string quoted = dumped(escaped);
  return shortened(quoted.substr(1, quoted.size() - 2));
}

std::string compact(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

std::string shownText(std::string_view text) {
  return shown(nlohmann::json(std::string(text.substr(0, kShown))));
}

nlohmann::json parseJson(const std::string& text, const std::string& file) {
  using Event = nlohmann::json::parse_event_t;
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto check = [&](int depth, Event event, const nlohmann::json& parsed) {
    if (depth > kMaxDepth)
      throw InvalidInput(file + ": is nested deeper than the " + std::to_string(kMaxDepth) + " levels of a profile");
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw InvalidInput(file + ": has " + shown(parsed) + " twice in one object, expected every name once");
    return true;
  };
  try {
    return nlohmann::json::parse(text, check);
  } catch (const nlohmann::json::exception& e) {
    std::string what = e.what();
    if (const auto at = what.find("] "); at != std::string::npos) what = what.substr(at + 2);
    std::replace_if(
        what.begin(), what.end(), [](char ch) { return ch < 0x20 || ch > 0x7e; }, '?');
    throw InvalidInput(file + ": is not a JSON document: " + what);
  }
}

JsonObjectReader::JsonObjectReader(const nlohmann::json& value, std::string file, std::string pointer)
    : value_(value), file_(std::move(file)), pointer_(std::move(pointer)) {
  if (!value_.is_object())
    throw InvalidInput(file_ + ": " + (pointer_.empty() ? "/" : pointer_) + " is " + shown(value_) +
                       ", expected an object");
}

std::string JsonObjectReader::where(const std::string& key) const {
  return file_ + ": " + pointer_ + "/" + pointerToken(key);
}

void JsonObjectReader::fail(const std::string& key, std::string_view expected) const {
  throw InvalidInput(where(key) + " is " + shown(value_.at(key)) + ", expected " + std::string(expected));
}

bool JsonObjectReader::has(const std::string& key) {
  known_.insert(key);
  return value_.contains(key);
}

const nlohmann::json& JsonObjectReader::required(const std::string& key, std::string_view expected) {
  if (!has(key)) throw InvalidInput(where(key) + " is missing, expected " + std::string(expected));
  return value_.at(key);
}

double JsonObjectReader::checkedNumber(const nlohmann::json& v, const std::string& key,
                                       std::string_view expected) const {
  if (!v.is_number() || !std::isfinite(v.get<double>())) fail(key, expected);
  return v.get<double>();
}

double JsonObjectReader::number(const std::string& key, double low, double high, bool open) {
  const std::string expected = std::string("a number ") + (open ? "between " : "from ") + compact(low) +
                               (open ? " and " : " to ") + compact(high);
  const double value = checkedNumber(required(key, expected), key, expected);
  const bool outside = open ? value <= low || value >= high : value < low || value > high;
  if (outside) fail(key, expected);
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
  const std::string expected = "a text that is not empty";
  const nlohmann::json& v = required(key, expected);
  if (!v.is_string() || v.get_ref<const std::string&>().empty()) fail(key, expected);
  return v.get<std::string>();
}

std::string JsonObjectReader::fileName(const std::string& key) {
  std::string name = string(key);
  const bool printable = std::all_of(name.begin(), name.end(),
                                     [](char ch) { return static_cast<unsigned char>(ch) >= 0x20 && ch != 0x7f; });
  if (!printable) fail(key, "the name of a file without control characters");
  return name;
}

std::vector<double> JsonObjectReader::numbers(const std::string& key, std::size_t least, std::size_t most) {
  const std::string expected =
      "a list of " + std::to_string(least) + (most == least ? "" : " to " + std::to_string(most)) + " numbers";
  const nlohmann::json& v = required(key, expected);
  if (!v.is_array() || v.size() < least || v.size() > most) fail(key, expected);
  std::vector<double> result;
  result.reserve(v.size());
  for (const auto& item : v) result.push_back(checkedNumber(item, key, expected));
  return result;
}

Vec3 JsonObjectReader::vector(const std::string& key) {
  const auto v = numbers(key, 3, 3);
  Vec3 p(v[0], v[1], v[2]);
  if (p.cwiseAbs().maxCoeff() > kMaxCoordinate) fail(key, "coordinates within " + compact(kMaxCoordinate) + " mm");
  return p;
}

std::vector<Vec3> JsonObjectReader::vectors(const std::string& key, std::size_t most) {
  const std::string expected =
      "a list of at most " + std::to_string(most) + " triples of numbers within " + compact(kMaxCoordinate) + " mm";
  const nlohmann::json& v = required(key, expected);
  if (!v.is_array() || v.size() > most) fail(key, expected);
  std::vector<Vec3> result;
  for (const auto& item : v) {
    if (!item.is_array() || item.size() != 3) fail(key, expected);
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) p[static_cast<Eigen::Index>(k)] = checkedNumber(item[k], key, expected);
    if (p.cwiseAbs().maxCoeff() > kMaxCoordinate) fail(key, expected);
    result.push_back(p);
  }
  return result;
}

JsonObjectReader JsonObjectReader::object(const std::string& key) {
  return {required(key, "an object"), file_, pointer_ + "/" + key};
}

void JsonObjectReader::finish() const {
  for (const auto& [key, value] : value_.items()) {
    if (known_.contains(key)) continue;
    std::string names;
    for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
    throw InvalidInput(where(key) + " is " + shown(value) + " but not a known field, expected one of " + names);
  }
}

}  // namespace vantage
