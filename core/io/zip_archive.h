#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_bytes.h"

namespace vantage {

struct ZipMember {
  std::string name;
  std::uint16_t method = 0;  ///< 0 stored, 8 deflated
  bool encrypted = false;
  std::uint32_t checksum = 0;  ///< CRC-32 of the unpacked bytes
  std::uint64_t packed = 0;    ///< [bytes]
  std::uint64_t unpacked = 0;  ///< as the directory says [bytes]
  std::uint64_t offset = 0;    ///< of its local header
};

[[nodiscard]] bool looksLikeZip(std::string_view bytes);

/// A zip archive, with or without zip64 fields (PKWARE APPNOTE), seen through its central directory.
class ZipArchive {
 public:
  /// @param maxUnpacked limit of what all members together may unpack to [bytes].
  /// @throws InvalidInput naming the file when the directory is missing or cannot be read (the archive is truncated or
  /// damaged), or
  ///         when it says that the members unpack to more than the limit.
  ZipArchive(const FileBytes& file, std::uintmax_t maxUnpacked);

  [[nodiscard]] const std::vector<ZipMember>& members() const { return members_; }

  /// The member of that name; a slash before it and the case of letters do not matter.
  [[nodiscard]] const ZipMember* find(std::string_view name) const;

  /// @throws InvalidInput when the member is encrypted, packed in an unknown way, cut off, or not what its size and
  ///         checksum say
  [[nodiscard]] std::string unpack(const ZipMember& member) const;

 private:
  void readDirectory(std::uintmax_t maxUnpacked);
  [[noreturn]] void fail(const std::string& what) const;

  const FileBytes& file_;
  std::vector<ZipMember> members_;
};

}  // namespace vantage
