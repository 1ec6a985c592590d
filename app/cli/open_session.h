#pragma once

#include <string>

#include "cli/command.h"
#include "session/session.h"

namespace vantage {

/// Opens a session and says on stderr what of it is lost.
[[nodiscard]] Session openSession(const std::string& path, SessionAccess access, CommandContext& context);

/// Reads everything in a session, and says on stderr what is not as it was written.
void checkSession(const Session& session, CommandContext& context);

/// The state at the cursor of a session, opened for reading.
[[nodiscard]] std::shared_ptr<const AcquisitionState> readSession(const std::string& path, CommandContext& context);

/// The same with the object in its views and model, whichever stand is worked on: what has been put together so far.
[[nodiscard]] std::shared_ptr<const AcquisitionState> readObject(const std::string& path, CommandContext& context);

/// A model, and what was taken off its scans (see worldOffset).
struct SessionModel {
  std::shared_ptr<const Model> model;
  Vec3 offset = Vec3::Zero();                     ///< [mm]
  std::shared_ptr<const AcquisitionState> state;  ///< that it is the model of
};

/// The model of the object at the cursor.
/// @throws InvalidInput when there is none yet
[[nodiscard]] SessionModel readSessionModel(const std::string& path, CommandContext& context);

}  // namespace vantage
