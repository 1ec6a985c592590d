#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace vantage {

/// Files larger than this are not read: no mesh or range image of ours comes near it.
inline constexpr std::uintmax_t kMaxFileBytes = 1ULL << 30;

/// The size of a file that can be read as data. Pipes and devices are refused before they are opened: they could block.
/// @throws IoError when it is missing, a folder, no regular file, empty, or larger than `limit`.
[[nodiscard]] std::size_t checkedFileSize(const std::string& path, std::uintmax_t limit = kMaxFileBytes);

/// A file read whole.
class FileBytes {
 public:
  /// @throws IoError as checkedFileSize, and when reading fails.
  explicit FileBytes(std::string path, std::uintmax_t limit = kMaxFileBytes);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::string_view text() const { return {data_.get(), size_}; }

 private:
  std::string path_;
  std::size_t size_;
  std::unique_ptr<char[]> data_;
};

/// The first `count` bytes of a file, or all of it when it is shorter.
/// @throws IoError as FileBytes; no file is too large for it.
[[nodiscard]] std::string readHead(const std::string& path, std::size_t count);

/// A file of text in UTF-16, told by its byte order mark, as bytes of which only ASCII is kept ('?' for the rest);
/// nothing when the bytes carry no such mark.
[[nodiscard]] std::string asciiFromUtf16(std::string_view bytes);

}  // namespace vantage
