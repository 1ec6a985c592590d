#pragma once

#include <vector>

#include "session/database.h"
#include "session/loss.h"

namespace vantage {

/// What of a session of an earlier version is not as it was written, before it is brought up to date. Version 2 gave
/// every step a hash of the state that it led to: steps that do not fit theirs are named. Of version 1 nothing is
/// known.
/// @throws IoError when the database fails
[[nodiscard]] std::vector<Loss> earlierDamages(Database& database, int version);

}  // namespace vantage
