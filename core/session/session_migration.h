#pragma once

#include "session/database.h"

namespace vantage {

/// Brings the tables of a session of an earlier version up to date, all or nothing. What it says stays what it said:
/// rows that are damaged stay as they are.
/// @throws InvalidInput when a setting of the file itself is missing or damaged; IoError
void migrateSession(Database& database);

}  // namespace vantage
