#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "acquisition/setting_field.h"

/// How a member of the settings becomes a line of their table: number<&AcquisitionSettings::planner,
/// &PlannerOptions::tolerance>(...). The kind of the field follows from the member's type; a type of its own needs
/// valueFrom and assign here.
namespace vantage::setting_member {

// The member that a path of pointers leads to.
template <auto First, auto... Rest>
constexpr auto& at(auto& object) {
  if constexpr (sizeof...(Rest) == 0)
    return object.*First;
  else
    return at<Rest...>(object.*First);
}

template <typename T>
requires(std::is_integral_v<T> && !std::is_same_v<T, bool>) SettingValue valueFrom(T member) {
  return static_cast<std::uint64_t>(member);
}
inline SettingValue valueFrom(bool member) {
  return member;
}
inline SettingValue valueFrom(double member) {
  return member;
}
inline SettingValue valueFrom(const std::optional<double>& member) {
  return member ? SettingValue(*member) : SettingValue();
}
inline SettingValue valueFrom(const std::string& member) {
  return member;
}
inline SettingValue valueFrom(const Strategy& member) {
  return name(member);
}
inline SettingValue valueFrom(Placement member) {
  return std::string(name(member));
}
inline SettingValue valueFrom(PatchWeight member) {
  return std::string(name(member));
}

template <typename T>
requires(std::is_arithmetic_v<T>) void assign(T& member, const SettingValue& value) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, double>)
    member = std::get<T>(value);
  else
    member = static_cast<T>(std::get<std::uint64_t>(value));
}
inline void assign(std::optional<double>& member, const SettingValue& value) {
  const auto* number = std::get_if<double>(&value);
  member = number != nullptr ? std::optional(*number) : std::nullopt;
}
inline void assign(std::string& member, const SettingValue& value) {
  member = std::get<std::string>(value);
}
inline void assign(Strategy& member, const SettingValue& value) {
  member = parseStrategy(std::get<std::string>(value));
}
inline void assign(Placement& member, const SettingValue& value) {
  member = parsePlacement(std::get<std::string>(value));
}
inline void assign(PatchWeight& member, const SettingValue& value) {
  const bool triangle = std::get<std::string>(value) == name(PatchWeight::TriangleArea);
  member = triangle ? PatchWeight::TriangleArea : PatchWeight::SpacingTimesLength;
}

template <auto... Path>
using Member = std::remove_reference_t<decltype(at<Path...>(std::declval<AcquisitionSettings&>()))>;

template <auto... Path>
SettingField field(SettingAudience audience, SettingField::Kind kind, const char* key, const char* label,
                   const char* before, const char* help) {
  SettingField field;
  field.audience = audience;
  field.kind = kind;
  field.key = key;
  field.label = label;
  field.before = before;
  field.help = help;
  field.get = [](const AcquisitionSettings& settings) { return valueFrom(at<Path...>(settings)); };
  field.set = [](AcquisitionSettings& settings, const SettingValue& value) { assign(at<Path...>(settings), value); };
  return field;
}

template <auto... Path>
SettingField number(SettingAudience audience, const char* key, const char* label, const char* unit, double least,
                    double most, const char* before, const char* help) {
  using T = Member<Path...>;
  constexpr bool kAutomatic = std::is_same_v<T, std::optional<double>>;
  SettingField result =
      field<Path...>(audience, std::is_integral_v<T> ? SettingField::Kind::Whole : SettingField::Kind::Number, key,
                     label, before, help);
  result.automatic = kAutomatic;
  result.unit = unit;
  result.least = least;
  result.most = most;
  return result;
}

template <auto... Path>
SettingField onOff(SettingAudience audience, const char* key, const char* label, const char* before, const char* help) {
  return field<Path...>(audience, SettingField::Kind::Switch, key, label, before, help);
}

template <auto... Path>
SettingField choice(SettingAudience audience, const char* key, const char* label, std::vector<std::string_view> choices,
                    const char* before, const char* help) {
  SettingField result = field<Path...>(audience, SettingField::Kind::Choice, key, label, before, help);
  result.choices = std::move(choices);
  return result;
}

template <auto... Path>
SettingField text(SettingAudience audience, const char* key, const char* label, const char* before, const char* help) {
  return field<Path...>(audience, SettingField::Kind::Text, key, label, before, help);
}

}  // namespace vantage::setting_member
