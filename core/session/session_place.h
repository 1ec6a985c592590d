#pragma once

#include <optional>
#include <string>

#include "session/session.h"

namespace vantage {

/// Whether a session may be made at a path, to be asked before work that takes long.
/// @throws InvalidInput when something is there: anything, or with `replace` what is no session
void checkSessionPlace(const std::string& path, bool replace);

/// The place of a session that is about to be made. Nothing that is there is ever lost: without the wish to replace it,
/// it is refused; with it, a session there is set aside, and comes back unless keep() or release() was called. What was
/// made goes then.
class SessionPlace {
 public:
  /// @throws as checkSessionPlace; IoError when a session cannot be set aside, also because another program writes to
  /// it
  SessionPlace(std::string path, bool replace);
  ~SessionPlace();
  SessionPlace(const SessionPlace&) = delete;
  SessionPlace& operator=(const SessionPlace&) = delete;

  /// The new session. It must be closed before the place is left. @throws as Session::create
  [[nodiscard]] Session make(const SessionStart& start);
  /// The new session is whole: the one that was set aside goes.
  void keep();
  /// The new session is not whole but can be gone on with: the one that was set aside stays there, see aside().
  void release() { done_ = true; }
  /// Where the old session is; nothing when there was none.
  [[nodiscard]] const std::optional<std::string>& aside() const { return aside_; }

 private:
  void putBack() noexcept;

  std::string path_;
  std::optional<std::string> aside_;
  bool made_ = false;
  bool done_ = false;
};

}  // namespace vantage
