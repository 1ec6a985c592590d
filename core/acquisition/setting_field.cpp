#include "acquisition/setting_field.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/errors.h"

namespace vantage {
namespace {

using Kind = SettingField::Kind;

constexpr std::string_view kAutomatic = "auto";
constexpr int kMostDigits = 17;
// Numbers between these are written without an exponent.
constexpr double kLeastPlain = 1e-4;
constexpr double kMostPlain = 1e15;

template <typename T>
std::optional<T> parsed(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// The fewest digits that come back to the angle.
double inDegrees(double angle) {
  const double exact = degrees(angle);
  std::array<char, 32> text;
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), exact, std::chars_format::general, digits).ptr;
    const auto rounded = parsed<double>({text.data(), static_cast<std::size_t>(end - text.data())});
    if (rounded && radians(*rounded) == angle) return *rounded;
  }
  return exact;
}

[[noreturn]] void refuse(const SettingField& field, const std::string& text) {
  throw InvalidInput(std::string(field.key) + " is " + text + ", expected " + expectationOf(field));
}

bool isInside(const SettingField& field, double value) {
  return value >= field.least && value <= field.most;
}

// Whole numbers are numbers too.
SettingValue numberFor(const SettingField& field, const SettingValue& value) {
  const auto* whole = std::get_if<std::uint64_t>(&value);
  if (field.kind == Kind::Number && whole != nullptr) return static_cast<double>(*whole);
  return value;
}

bool isPossible(const SettingField& field, const SettingValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return field.automatic;
  switch (field.kind) {
    case Kind::Switch:
      return std::holds_alternative<bool>(value);
    case Kind::Whole: {
      const auto* whole = std::get_if<std::uint64_t>(&value);
      return whole != nullptr && isInside(field, static_cast<double>(*whole));
    }
    case Kind::Number: {
      const auto* number = std::get_if<double>(&value);
      return number != nullptr && isInside(field, *number);
    }
    case Kind::Choice: {
      const auto* name = std::get_if<std::string>(&value);
      return name != nullptr && std::find(field.choices.begin(), field.choices.end(), *name) != field.choices.end();
    }
    case Kind::Text:
      return std::holds_alternative<std::string>(value);
  }
  return false;
}

std::optional<SettingValue> valueFrom(const SettingField& field, std::string_view text) {
  if (field.automatic && text == kAutomatic) return SettingValue();
  switch (field.kind) {
    case Kind::Switch:
      if (text == "true") return true;
      if (text == "false") return false;
      return std::nullopt;
    case Kind::Whole:
      return parsed<std::uint64_t>(text);
    case Kind::Number:
      return parsed<double>(text);
    case Kind::Choice:
    case Kind::Text:
      return std::string(text);
  }
  return std::nullopt;
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) {
    if (!text.empty()) text.append(", ");
    text.append(name);
  }
  return text;
}

std::string boundsOf(const SettingField& field) {
  std::string text = "from " + settingText(field.least) + " to " + settingText(field.most);
  if (!field.unit.empty()) text.append(" ").append(field.unit);
  return text;
}

}  // namespace

std::string_view groupOf(const SettingField& field) {
  const std::size_t dot = field.key.find('.');
  return dot == std::string_view::npos ? std::string_view() : field.key.substr(0, dot);
}

SettingValue valueOf(const SettingField& field, const AcquisitionSettings& settings) {
  SettingValue value = field.get(settings);
  if (auto* number = std::get_if<double>(&value); number != nullptr && field.unit == "deg")
    *number = inDegrees(*number);
  return value;
}

void setValue(const SettingField& field, AcquisitionSettings& settings, const SettingValue& value) {
  SettingValue wanted = numberFor(field, value);
  if (!isPossible(field, wanted)) refuse(field, settingText(value));
  if (auto* number = std::get_if<double>(&wanted); number != nullptr && field.unit == "deg") *number = radians(*number);
  field.set(settings, wanted);
}

std::string settingText(const SettingValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return std::string(kAutomatic);
  if (const auto* on = std::get_if<bool>(&value)) return *on ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) return std::to_string(*whole);
  const double number = std::get<double>(value);
  const bool plain = number == 0.0 || (std::abs(number) >= kLeastPlain && std::abs(number) < kMostPlain);
  std::array<char, 64> text;
  char* last = text.data() + text.size();
  const auto end = plain ? std::to_chars(text.data(), last, number, std::chars_format::fixed).ptr
                         : std::to_chars(text.data(), last, number).ptr;
  return {text.data(), end};
}

std::string textOf(const SettingField& field, const AcquisitionSettings& settings) {
  return settingText(valueOf(field, settings));
}

void setText(const SettingField& field, AcquisitionSettings& settings, std::string_view text) {
  const auto value = valueFrom(field, text);
  if (!value) refuse(field, "'" + std::string(text) + "'");
  setValue(field, settings, *value);
}

std::string expectationOf(const SettingField& field) {
  std::string text;
  switch (field.kind) {
    case Kind::Switch:
      text = "true or false";
      break;
    case Kind::Whole:
      text = "a whole number " + boundsOf(field);
      break;
    case Kind::Number:
      text = "a number " + boundsOf(field);
      break;
    case Kind::Choice:
      text = "one of " + listed(field.choices);
      break;
    case Kind::Text:
      text = "a text";
      break;
  }
  return field.automatic ? text + ", or auto" : text;
}

}  // namespace vantage
