#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "acquisition/settings.h"

namespace vantage {

/// All settings, as people give them, by their keys (see settingFields). Angles come back to the last bit when they
/// were set in degrees, all else always.
[[nodiscard]] nlohmann::ordered_json settingsJson(const AcquisitionSettings& settings);

/// The settings that a step of a session was made with. What the object does not name means what it meant before it
/// could be named, whatever the defaults are today; what every version has named must be there. Names of earlier
/// versions are understood.
/// @param what the object is called in errors
/// @throws InvalidInput that names key, value and what was expected.
[[nodiscard]] AcquisitionSettings settingsFromJson(const nlohmann::json& json, const std::string& what);

/// A profile of options, to be kept in a file: all settings but those that belong to one session.
[[nodiscard]] std::string optionsText(const AcquisitionSettings& settings);

/// The settings with those that a profile of options names.
/// @param what the text is called in errors: a file
/// @throws InvalidInput that names key, value and what was expected.
[[nodiscard]] AcquisitionSettings withOptions(AcquisitionSettings settings, const std::string& text,
                                              const std::string& what);

/// The same from and to a file. @throws IoError; InvalidInput also for settings that contradict each other.
[[nodiscard]] AcquisitionSettings readOptions(const std::string& path, AcquisitionSettings settings);
void writeOptions(const std::string& path, const AcquisitionSettings& settings);

}  // namespace vantage
