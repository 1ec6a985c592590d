#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "acquisition/settings.h"

namespace vantage {

/// A setting as people give it: angles in degrees, choices by name. Nothing stands for a setting that is found
/// automatically.
using SettingValue = std::variant<std::monostate, bool, std::uint64_t, double, std::string>;

/// Where a setting is asked for.
enum class SettingAudience : std::uint8_t {
  Basic,    ///< by everybody
  Expert,   ///< by those who know the algorithms: folded away
  Session,  ///< belongs to one session: no part of a profile of options
};

/// One setting: what it is called, what it means, what it can be, and where in the settings it is.
struct SettingField {
  enum class Kind : std::uint8_t { Switch, Whole, Number, Choice, Text };

  SettingAudience audience = SettingAudience::Expert;
  Kind kind = Kind::Number;
  bool automatic = false;  ///< may be unset
  std::string_view key;    ///< "planner.overlap_share": group and name; never changes, as it stands in files
  std::string_view label;  ///< a few words
  std::string_view unit;   ///< "mm", "mm2", "deg", "samples" (sample spacings), or empty
  double least = 0.0;      ///< of numbers, in the unit
  double most = 0.0;
  /// What a session file that does not name the setting means, as text. Written once and for all: it stays when the
  /// default changes.
  std::string_view before;
  std::string_view help;  ///< one sentence
  std::vector<std::string_view> choices;

  /// As the engine has it: angles in radians.
  SettingValue (*get)(const AcquisitionSettings& settings) = nullptr;
  void (*set)(AcquisitionSettings& settings, const SettingValue& value) = nullptr;
};

/// "planner" of "planner.overlap_share"; empty for settings of the acquisition itself.
[[nodiscard]] std::string_view groupOf(const SettingField& field);

[[nodiscard]] SettingValue valueOf(const SettingField& field, const AcquisitionSettings& settings);

/// An angle comes back from valueOf to the last bit when it was set in degrees.
/// @throws InvalidInput that names key, value and what was expected; the settings stay as they are.
void setValue(const SettingField& field, AcquisitionSettings& settings, const SettingValue& value);

/// "0.1", "true", "fit", "auto". Numbers come back to the last bit.
[[nodiscard]] std::string settingText(const SettingValue& value);
[[nodiscard]] std::string textOf(const SettingField& field, const AcquisitionSettings& settings);

/// The opposite. @throws like setValue
void setText(const SettingField& field, AcquisitionSettings& settings, std::string_view text);

/// What a setting can be: "a number from 0 to 1 mm, or auto", "one of as-is, fit".
[[nodiscard]] std::string expectationOf(const SettingField& field);

}  // namespace vantage
