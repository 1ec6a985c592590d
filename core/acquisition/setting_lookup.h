#pragma once

#include <string_view>

#include "acquisition/setting_field.h"

namespace vantage {

/// @throws InvalidInput when no setting has the key; says which key is nearest.
[[nodiscard]] const SettingField& settingField(std::string_view key);

/// What a group of settings is called: "Planning". Settings of a group follow each other in the table.
/// @throws InvalidInput for a group that no setting has.
[[nodiscard]] std::string_view groupLabel(std::string_view group);

}  // namespace vantage
