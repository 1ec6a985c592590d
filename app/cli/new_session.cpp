#include "cli/new_session.h"

#include <filesystem>
#include <optional>

#include "base/errors.h"
#include "session/session_place.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// Whether what became of the session is worth going on with.
bool resumable(const Session& session, bool cancelled, bool goesOn) {
  return session.scanCount() > 0 && (cancelled || goesOn);
}

}  // namespace

void workOnNewSession(const NewSession& made, CommandContext& context, const std::function<void(Session&)>& work) {
  SessionPlace place(made.file, made.replace);
  std::optional<Session> session(place.make(made.start));
  const auto leave = [&](bool cancelled) {
    const bool stays = resumable(*session, cancelled, made.goesOn);
    session.reset();
    if (!stays) return;
    place.release();
    if (place.aside()) context.note("the session that was to be replaced is kept as " + *place.aside());
  };
  try {
    work(*session);
  } catch (const Cancelled&) {
    leave(true);
    throw;
  } catch (...) {
    leave(false);
    throw;
  }
  session.reset();
  place.keep();
}

NewFolder::NewFolder(const std::string& path) {
  std::error_code error;
  for (fs::path folder = fs::absolute(path).lexically_normal(); !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path())
    made_.push_back(folder.string());
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path)) throw IoError(path, "cannot be made a folder: " + error.message());
}

NewFolder::~NewFolder() {
  std::error_code error;
  for (const std::string& folder : made_) fs::remove(folder, error);
}

}  // namespace vantage
