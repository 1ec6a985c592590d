#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "session/session.h"

namespace vantage {

/// How a command makes a new session.
struct NewSession {
  std::string file;
  bool replace = false;  ///< a session there is set aside until the new one is whole
  bool goesOn = false;   ///< what fails after the first view can be resumed; else only what is cancelled can
  SessionStart start;
};

/// Makes a session and works on it. When the work fails, the folder is as it was before, with two exceptions: a session
/// that was cancelled, and one that goes on and has scans, stays, and what it was to replace stays beside it.
/// @throws InvalidInput when the name is taken; IoError; what `work` throws
void workOnNewSession(const NewSession& made, CommandContext& context, const std::function<void(Session&)>& work);

/// Folders that a command makes for its results; those that are empty go again unless keep() was called.
class NewFolder {
 public:
  /// Makes a folder and those above it. @throws IoError
  explicit NewFolder(const std::string& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  void keep() { made_.clear(); }

 private:
  std::vector<std::string> made_;  // the innermost first
};

}  // namespace vantage
