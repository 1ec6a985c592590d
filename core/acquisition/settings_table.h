#pragma once

#include <span>

#include "acquisition/setting_field.h"

namespace vantage {

/// All settings of an acquisition, group by group. JSON, hash, equality, forms and the command line follow from this
/// table: a setting is added by its member and an entry here.
[[nodiscard]] std::span<const SettingField> settingFields();

}  // namespace vantage
