#pragma once

#include <string>
#include <vector>

#include "session/database.h"
#include "session/loss.h"

namespace vantage {

/// The database of a session, with the tables of kSessionSchema. What is damaged or of an earlier version is made good
/// in memory.
/// @param losses gets everything that is damaged.
/// @throws IoError, InvalidInput when it is not a session
[[nodiscard]] Database openSessionForReading(const std::string& path, std::vector<Loss>& losses);

/// The same to be written to. One that is damaged is copied beside itself before anything else, and what of it is
/// readable takes its place; one of an earlier version is brought up to date. The caller holds its SessionLock.
[[nodiscard]] Database openSessionForWriting(const std::string& path, std::vector<Loss>& losses);

}  // namespace vantage
