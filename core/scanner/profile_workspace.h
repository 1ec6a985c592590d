#pragma once

#include "scanner/profile.h"
#include "scanner/profile_reader.h"

namespace vantage {

/// The `workspace` object of a profile.
/// @throws InvalidInput that names file, JSON pointer, value and what was expected.
[[nodiscard]] Workspace readWorkspace(JsonObjectReader reader, const ProfileSource& source);

/// The text of a file that a profile names.
/// @throws IoError when the source does not hold it.
[[nodiscard]] const std::string& attachment(const ProfileSource& source, const std::string& name);

}  // namespace vantage
