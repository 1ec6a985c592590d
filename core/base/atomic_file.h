#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// A file that appears whole or not at all: it is written beside its place under another name and put there by
/// commit(). Without commit the other name is removed and what was there before stays. A link in its place stays: what
/// it names is written. A device or pipe is written to directly.
class AtomicFile {
 public:
  /// @throws IoError when the folder cannot be written to, or the path is a folder.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Room for `bytes` more bytes, to be filled before the next call. @pre bytes <= kMaxPiece
  /// @throws IoError when what came before cannot be written (disk full).
  [[nodiscard]] char* grow(std::size_t bytes);
  void write(std::string_view text);

  /// @throws IoError when the rest cannot be written or the file not put into its place.
  void commit();
  /// The same where nothing is yet. @return whether it was so; what came there meanwhile stays.
  /// @throws IoError like commit()
  [[nodiscard]] bool commitNew();

  static constexpr std::size_t kMaxPiece = 1U << 16;

 private:
  void flush();
  void finish();
  void discard() noexcept;
  [[noreturn]] void fail(const std::string& what);

  std::string path_;
  std::string written_;  // where the bytes go until commit
  int descriptor_ = -1;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace vantage
