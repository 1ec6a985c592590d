#include "base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr std::size_t kBufferBytes = 1U << 18;
constexpr int kMaxNames = 1000;
constexpr mode_t kMode = 0666;  // less the umask

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), buffer_(kBufferBytes) {
  std::error_code error;
  // A link stays one: what it names is written.
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(path_, error)))
    if (auto target = std::filesystem::canonical(path_, error); !error) path_ = target.string();
  const auto status = std::filesystem::status(path_, error);
  if (std::filesystem::is_directory(status)) throw IoError(path_, "is a folder, expected a file to write");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    written_ = path_;
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    for (int i = 0; i < kMaxNames && descriptor_ < 0; ++i) {
      written_ = path_ + "." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".part";
      descriptor_ = ::open(written_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
  }
  if (descriptor_ < 0) throw IoError(path_, std::string("cannot be opened for writing: ") + std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  discard();
}

char* AtomicFile::grow(std::size_t bytes) {
  if (used_ + bytes > buffer_.size()) flush();
  char* at = buffer_.data() + used_;
  used_ += bytes;
  return at;
}

void AtomicFile::write(std::string_view text) {
  while (!text.empty()) {
    const std::size_t count = std::min(text.size(), kMaxPiece);
    std::memcpy(grow(count), text.data(), count);
    text.remove_prefix(count);
  }
}

void AtomicFile::flush() {
  for (std::size_t done = 0; done < used_;) {
    const ssize_t sent = ::write(descriptor_, buffer_.data() + done, used_ - done);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) fail(std::string("cannot be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(sent);
  }
  used_ = 0;
}

void AtomicFile::finish() {
  flush();
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0) fail(std::string("cannot be written: ") + std::strerror(errno));
}

void AtomicFile::commit() {
  finish();
  if (written_ != path_ && std::rename(written_.c_str(), path_.c_str()) != 0)
    fail(std::string("cannot be put into its place: ") + std::strerror(errno));
  written_.clear();
}

bool AtomicFile::commitNew() {
  finish();
  // Whoever makes the name has it: not every file system renames without replacing.
  const int made = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
  if (made < 0 && errno != EEXIST) fail(std::string("cannot be put into its place: ") + std::strerror(errno));
  if (made < 0) {
    discard();
    return false;
  }
  ::close(made);
  if (std::rename(written_.c_str(), path_.c_str()) != 0) {
    const int why = errno;
    ::unlink(path_.c_str());
    fail(std::string("cannot be put into its place: ") + std::strerror(why));
  }
  written_.clear();
  return true;
}

void AtomicFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!written_.empty() && written_ != path_) ::unlink(written_.c_str());
  written_.clear();
}

void AtomicFile::fail(const std::string& what) {
  discard();
  throw IoError(path_, what);
}

}  // namespace vantage
