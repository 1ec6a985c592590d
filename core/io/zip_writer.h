#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/atomic_file.h"

namespace vantage {

/// A member of a zip archive while it is packed (deflate). Given the same text it packs the same bytes.
class PackedMember {
 public:
  explicit PackedMember(std::string name);
  ~PackedMember();
  PackedMember(PackedMember&&) noexcept;
  PackedMember& operator=(PackedMember&&) noexcept;
  PackedMember(const PackedMember&) = delete;
  PackedMember& operator=(const PackedMember&) = delete;

  void write(std::string_view text);

 private:
  friend class ZipWriter;
  struct Stream;
  void pack(std::string_view text, bool last);

  std::string name_;
  std::unique_ptr<Stream> stream_;
  std::string packed_;
  std::uint64_t unpacked_ = 0;
  std::uint32_t checksum_ = 0;
};

/// Writes a zip archive (PKWARE APPNOTE, without zip64): members one after the other, then the directory. Members have
/// no date, so that the same content is the same file.
class ZipWriter {
 public:
  /// @param file must outlive it.
  explicit ZipWriter(AtomicFile& file) : file_(file) {}

  /// @throws InvalidInput when the archive would become larger than 4 GB; IoError
  void add(PackedMember member);
  /// Writes the directory; nothing can be added afterwards. @throws IoError
  void finish();

 private:
  void writePieces(std::string_view bytes);

  AtomicFile& file_;
  std::string directory_;
  std::uint64_t at_ = 0;
  std::uint16_t members_ = 0;
};

}  // namespace vantage
