#include "cli/new_session.h"

#include <filesystem>
#include <optional>

#include "base/errors.h"
#include "session/session_place.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

}  // namespace

void workOnNewSession(const NewSession& made, CommandContext& context, const std::function<void(Session&)>& work) {
  SessionPlace place(made.file, made.replace);
  std::optional<Session> session(place.make(made.start));
  const auto leave = [&](bool resumable) {
    session.reset();
    if (!resumable) return;
    place.release();
    if (place.aside()) context.note("the session that was to be replaced is kept as " + *place.aside());
  };
  try {
    work(*session);
  } catch (const Cancelled&) {
    leave(session->scanCount() > 0);
    throw;
  } catch (const InvalidInput&) {
    // Without a model the same input would be refused again.
    leave(made.goesOn && session->state()->model != nullptr);
    throw;
  } catch (...) {
    leave(made.goesOn && session->scanCount() > 0);
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
