#pragma once

#include "session/database.h"

namespace vantage {

/// Session files up to schema 2 called every end "finished" that was not forced: also what the operator had ended while
/// there was something left to scan, and what was imported. Tells them apart, in the tables of kSessionSchema: in the
/// column termination and in the commands that ended it. @throws IoError
void renameEarlierEndings(Database& database);

}  // namespace vantage
