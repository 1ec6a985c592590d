#include "session/session_place.h"

#include <array>
#include <filesystem>
#include <utility>

#include "base/errors.h"
#include "io/file_kind.h"
#include "session/session_lock.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// A database and what of it is not yet in its file.
constexpr std::array<const char*, 3> kParts{"-wal", "-shm", ""};

bool isSession(const std::string& path) {
  try {
    return fs::is_regular_file(path) && detectFileKind(path) == FileKind::Session;
  } catch (const Error&) {
    return false;
  }
}

// "mug-before.vantage", "mug-before-2.vantage", ... beside the session.
std::string freeNameBeside(const fs::path& path) {
  const std::string stem = path.stem().string() + "-before";
  for (int i = 1;; ++i) {
    fs::path name = path;
    name.replace_filename((i == 1 ? stem : stem + "-" + std::to_string(i)) + path.extension().string());
    if (!fs::exists(fs::symlink_status(name))) return name.string();
  }
}

void moveAll(const std::string& from, const std::string& to) {
  for (const char* part : kParts)
    if (fs::exists(from + part)) fs::rename(from + part, to + part);
}

void removeAll(const std::string& path) noexcept {
  std::error_code error;
  for (const char* part : kParts) fs::remove(path + part, error);
}

}  // namespace

void checkSessionPlace(const std::string& path, bool replace) {
  if (!fs::exists(fs::symlink_status(path))) return;
  if (!isSession(path))
    throw InvalidInput(path + ": is there already and is no session, so it is not replaced: choose another name");
  if (!replace)
    throw InvalidInput(path +
                       ": is a session already and stays as it is: go on with it (resume), choose another "
                       "name, or say --replace");
}

SessionPlace::SessionPlace(std::string path, bool replace) : path_(std::move(path)) {
  checkSessionPlace(path_, replace);
  if (!fs::exists(path_)) return;
  const SessionLock lock(path_);
  const std::string aside = freeNameBeside(path_);
  try {
    moveAll(path_, aside);
  } catch (const fs::filesystem_error& e) {
    throw IoError(path_, "cannot be set aside as " + aside + ": " + e.code().message());
  }
  aside_ = aside;
}

SessionPlace::~SessionPlace() {
  if (!done_) putBack();
}

Session SessionPlace::make(const SessionStart& start) {
  Session session = Session::create(path_, start);
  made_ = true;
  return session;
}

void SessionPlace::keep() {
  done_ = true;
  if (aside_) removeAll(*aside_);
  aside_.reset();
}

void SessionPlace::putBack() noexcept {
  if (made_) removeAll(path_);
  try {
    if (aside_ && !fs::exists(fs::symlink_status(path_))) moveAll(*aside_, path_);
  } catch (...) {
    // It stays where it was set aside.
    return;
  }
}

}  // namespace vantage
