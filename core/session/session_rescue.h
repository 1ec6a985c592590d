#pragma once

#include <string>
#include <vector>

#include "session/database.h"
#include "session/loss.h"

namespace vantage {

/// Copies the readable rows of a session whose database is damaged into an empty database.
/// @return the tables that are not whole.
/// @throws IoError when the copy cannot be written
[[nodiscard]] std::vector<Loss> rescueRows(Database& damaged, Database& copy);

/// Copies a session and its write-ahead log, byte by byte, to the first free name `<session>.damaged-N`.
/// @return that name. @throws IoError
[[nodiscard]] std::string copyBeside(const std::string& session);

/// A name `<path><ending>-N` that no file has.
[[nodiscard]] std::string freeName(const std::string& path, const std::string& ending);

/// Replaces a damaged session by what of it can be read. A copy must have been made before.
/// @return as rescueRows. @throws IoError: the session is as it was
[[nodiscard]] std::vector<Loss> rescueInPlace(const std::string& session);

}  // namespace vantage
