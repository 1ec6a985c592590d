#pragma once

#include <string>

#include "base/errors.h"

namespace vantage {

/// Another program writes to a session: it can still be opened for reading.
class SessionInUse : public IoError {
 public:
  using IoError::IoError;
};

/// Who writes to a session: as long as it lives, no other program can. A file `<session>.lock` beside the session holds
/// process number, host and program of the holder; the operating system gives it free when the holder ends, however it
/// ends.
class SessionLock {
 public:
  /// @throws SessionInUse naming who holds it; IoError that the folder cannot be written to.
  explicit SessionLock(const std::string& session);
  ~SessionLock();
  SessionLock(SessionLock&& other) noexcept;
  SessionLock& operator=(SessionLock&&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace vantage
