#pragma once

#include <string>

namespace vantage {

/// Who writes to a session: as long as it lives, no other program can. A file `<session>.lock` beside the session holds
/// process number, host and program of the holder; the operating system gives it free when the holder ends, however it
/// ends.
class SessionLock {
 public:
  /// @throws IoError naming who holds it, or that the folder cannot be written to.
  explicit SessionLock(const std::string& session);
  ~SessionLock();
  SessionLock(SessionLock&& other) noexcept;
  SessionLock& operator=(SessionLock&&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace vantage
