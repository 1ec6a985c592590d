#include "session/session_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

std::string programName() {
  std::array<char, 4096> path{};
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  const std::string whole(path.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  return whole.substr(whole.rfind('/') + 1);
}

std::string hostName() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return host.data();
}

// What the holder wrote into the file, in one line.
std::string holderIn(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t length = pread(descriptor, text.data(), text.size(), 0);
  std::string holder(text.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  for (char& c : holder)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (!holder.empty() && holder.back() == ' ') holder.pop_back();
  return holder.empty() ? "another program" : holder;
}

bool sameFile(int descriptor, const std::string& path) {
  struct stat open {};
  struct stat named {};
  return fstat(descriptor, &open) == 0 && stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

}  // namespace

SessionLock::SessionLock(const std::string& session) : path_(session + ".lock") {
  // A holder that ends removes the file: whoever locked the removed one tries again.
  while (descriptor_ < 0) {
    const int descriptor = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (descriptor < 0)
      throw IoError(session,
                    std::string("cannot be written to: its folder takes no file (") + std::strerror(errno) + ")");
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const std::string holder = holderIn(descriptor);
      ::close(descriptor);
      throw SessionInUse(session, "is open for writing in " + holder + "; close it there, or open it for reading");
    }
    if (sameFile(descriptor, path_)) {
      descriptor_ = descriptor;
    } else {
      ::close(descriptor);
    }
  }
  const std::string holder = programName() + " (process " + std::to_string(getpid()) + " on " + hostName() + ")\n";
  // Who cannot be named still holds it.
  if (ftruncate(descriptor_, 0) == 0) static_cast<void>(!pwrite(descriptor_, holder.data(), holder.size(), 0));
}

SessionLock::SessionLock(SessionLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

SessionLock::~SessionLock() {
  if (descriptor_ < 0) return;
  unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace vantage
