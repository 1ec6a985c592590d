#include "io/file_bytes.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

class OpenFile {
 public:
  explicit OpenFile(const std::string& path) : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw IoError(path, std::string("cannot be opened for reading: ") + std::strerror(errno));
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  // Fewer bytes only at the end of the file.
  std::size_t read(char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got = ::read(descriptor_, to + done, count - done);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw IoError(path_, std::string("cannot be read: ") + std::strerror(errno));
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  const std::string& path_;
  int descriptor_;
};

}  // namespace

std::size_t checkedFileSize(const std::string& path, std::uintmax_t limit) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw IoError(path, "does not exist");
  if (fs::is_directory(status)) throw IoError(path, "is a folder, expected a file");
  if (error) throw IoError(path, "cannot be read: " + error.message());
  if (!fs::is_regular_file(status)) throw IoError(path, "is a device or pipe, expected a file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw IoError(path, "cannot be read: " + error.message());
  if (size == 0) throw IoError(path, "is empty (0 bytes)");
  if (size > limit)
    throw IoError(path, "has " + std::to_string(size) + " bytes, more than the " + std::to_string(limit) + " allowed");
  return static_cast<std::size_t>(size);
}

FileBytes::FileBytes(std::string path, std::uintmax_t limit)
    : path_(std::move(path)), size_(checkedFileSize(path_, limit)), data_(new char[size_]) {
  const std::size_t got = OpenFile(path_).read(data_.get(), size_);
  if (got != size_)
    throw IoError(path_,
                  "shrank while it was read: " + std::to_string(got) + " of " + std::to_string(size_) + " bytes");
}

std::string readHead(const std::string& path, std::size_t count) {
  const std::size_t size = checkedFileSize(path, std::numeric_limits<std::uintmax_t>::max());
  std::string head(std::min(count, size), '\0');
  head.resize(OpenFile(path).read(head.data(), head.size()));
  return head;
}

std::string asciiFromUtf16(std::string_view bytes) {
  const bool big = bytes.starts_with("\xfe\xff");
  if (!big && !bytes.starts_with("\xff\xfe")) return {};
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const char high = bytes[big ? i : i + 1];
    const char low = bytes[big ? i + 1 : i];
    text += high == 0 && static_cast<unsigned char>(low) < 0x80 ? low : '?';
  }
  return text;
}

}  // namespace vantage
