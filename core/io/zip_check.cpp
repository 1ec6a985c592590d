#include "io/zip_check.h"

#include <bit>
#include <cstring>

#include "base/errors.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little, "zip fields are copied as they are");

// Fixed parts of the records, and where their fields lie (PKWARE APPNOTE 4.3.12 and 4.3.16).
constexpr std::string_view kEndMark("PK\x05\x06", 4);
constexpr std::string_view kMemberMark("PK\x01\x02", 4);
constexpr std::size_t kEndBytes = 22;
constexpr std::size_t kMemberBytes = 46;
constexpr std::size_t kMaxComment = 65535;
// Archives with large numbers keep them elsewhere (4.3.14 and 4.5.3), and say so by the largest value of the field.
constexpr std::string_view kLargeEndMark("PK\x06\x06", 4);
constexpr std::size_t kLargeEndBytes = 56;
constexpr std::uint32_t kIn64 = 0xffffffffU;
constexpr std::uint16_t kIn64Members = 0xffffU;

template <typename T>
T fieldAt(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

[[noreturn]] void fail(const FileBytes& file, const char* what) {
  throw InvalidInput(file.path() + ": " + what + ": the archive is truncated or damaged");
}

struct Directory {
  std::uint64_t offset;
  std::uint64_t members;
};

Directory findDirectory(const FileBytes& file) {
  const std::string_view bytes = file.text();
  const std::size_t end = bytes.rfind(kEndMark);
  if (end == std::string_view::npos || bytes.size() - end < kEndBytes || bytes.size() - end > kEndBytes + kMaxComment)
    fail(file, "the zip directory is missing");
  const Directory directory{fieldAt<std::uint32_t>(bytes, end + 16), fieldAt<std::uint16_t>(bytes, end + 10)};
  const std::size_t large = bytes.rfind(kLargeEndMark, end);
  const bool isLarge = directory.offset == kIn64 || directory.members == kIn64Members;
  if (!isLarge) return directory;
  if (large == std::string_view::npos || bytes.size() - large < kLargeEndBytes) fail(file, "the zip64 directory is missing");
  return {fieldAt<std::uint64_t>(bytes, large + 48), fieldAt<std::uint64_t>(bytes, large + 32)};
}

// The unpacked size in the zip64 field among a member's extra fields, where it stands first.
std::uint64_t largeSize(const FileBytes& file, std::size_t at, std::size_t extraBytes) {
  const std::string_view bytes = file.text();
  if (at > bytes.size() || extraBytes > bytes.size() - at) fail(file, "the zip directory cannot be read");
  const std::size_t end = at + extraBytes;
  while (end - at >= 12) {
    if (fieldAt<std::uint16_t>(bytes, at) == 1) return fieldAt<std::uint64_t>(bytes, at + 4);
    const std::size_t field = 4U + fieldAt<std::uint16_t>(bytes, at + 2);
    if (field > end - at) break;
    at += field;
  }
  fail(file, "a zip64 size is missing");
}

}  // namespace

bool looksLikeZip(std::string_view bytes) { return bytes.starts_with(std::string_view("PK\x03\x04", 4)); }

std::uintmax_t unpackedBytes(const FileBytes& file) {
  const std::string_view bytes = file.text();
  const Directory directory = findDirectory(file);
  std::size_t at = directory.offset;
  std::uintmax_t total = 0;
  for (std::uint64_t i = 0; i < directory.members; ++i) {
    if (at > bytes.size() || bytes.size() - at < kMemberBytes || bytes.substr(at, 4) != kMemberMark)
      fail(file, "the zip directory cannot be read");
    const auto nameBytes = fieldAt<std::uint16_t>(bytes, at + 28);
    const auto extraBytes = fieldAt<std::uint16_t>(bytes, at + 30);
    const auto unpacked = fieldAt<std::uint32_t>(bytes, at + 24);
    total += unpacked != kIn64 ? unpacked : largeSize(file, at + kMemberBytes + nameBytes, extraBytes);
    at += kMemberBytes + nameBytes + extraBytes + fieldAt<std::uint16_t>(bytes, at + 32);
  }
  return total;
}

}  // namespace vantage
