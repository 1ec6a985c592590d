#pragma once

#include <memory>
#include <string>

#include "acquisition/acquisition.h"
#include "session/session.h"
#include "set_up.h"

namespace vantage {

/// "session.vantage" in a folder, or that name with the first number that is free.
[[nodiscard]] std::string freeSessionName(const std::string& folder);

/// Makes the session of a set-up in its folder, under a name that is still free.
/// @throws IoError
[[nodiscard]] std::shared_ptr<Session> createSession(const SetUp& setUp);

/// Keeps in the session what it is scanned with from now on. @throws IoError
void rememberDevices(Session& session, const SetUp& setUp);

struct OpenedSession {
  std::shared_ptr<Session> session;
  SharedSetUp setUp;
  SessionAccess access = SessionAccess::Write;
};
/// Opens a session with the set-up that it was begun with.
/// @throws SessionInUse where it is to be written to and another program does; IoError, InvalidInput, Cancelled
[[nodiscard]] OpenedSession openSession(const std::string& path, SessionAccess access, const std::string& cacheFolder,
                                        const Progress& progress);

}  // namespace vantage
