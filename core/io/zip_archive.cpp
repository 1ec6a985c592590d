#include "io/zip_archive.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little, "zip fields are copied as they are");

// Fixed parts of the records, and where their fields lie (PKWARE APPNOTE 4.3.7, 4.3.12, 4.3.14 and 4.3.16).
constexpr std::string_view kLocalMark("PK\x03\x04", 4);
constexpr std::string_view kMemberMark("PK\x01\x02", 4);
constexpr std::string_view kEndMark("PK\x05\x06", 4);
constexpr std::string_view kLargeEndMark("PK\x06\x06", 4);
constexpr std::size_t kLocalBytes = 30;
constexpr std::size_t kMemberBytes = 46;
constexpr std::size_t kEndBytes = 22;
constexpr std::size_t kLargeEndBytes = 56;
constexpr std::size_t kMaxComment = 65535;
// Numbers too large for their field stand in a zip64 record or extra field (4.5.3); then the field is full.
constexpr std::uint32_t kIn64 = 0xffffffffU;
constexpr std::uint16_t kIn64Members = 0xffffU;
constexpr std::uint16_t kExtra64 = 1;

constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kDeflated = 8;
constexpr std::uint16_t kEncryptedFlag = 1;

template <typename T>
T fieldAt(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

// Takes the numbers that did not fit from the zip64 extra field, in their order there. False when one is missing.
bool takeLargeNumbers(std::string_view extra, ZipMember& member) {
  while (extra.size() >= 4 && fieldAt<std::uint16_t>(extra, 0) != kExtra64)
    extra.remove_prefix(std::min<std::size_t>(extra.size(), 4U + fieldAt<std::uint16_t>(extra, 2)));
  std::size_t at = 4;
  for (std::uint64_t* number : {&member.unpacked, &member.packed, &member.offset}) {
    if (*number != kIn64) continue;
    if (extra.size() < at + 8) return false;
    *number = fieldAt<std::uint64_t>(extra, at);
    at += 8;
  }
  return true;
}

// Unpacks a deflated stream into `to`, which must become exactly full.
bool inflateInto(std::string_view packed, std::string& to) {
  z_stream stream{};
  if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
  // zlib does not write to its input.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(to.data());
  stream.avail_out = static_cast<uInt>(to.size());
  const int end = ::inflate(&stream, Z_FINISH);
  const bool full = stream.avail_out == 0;
  ::inflateEnd(&stream);
  return end == Z_STREAM_END && full;
}

}  // namespace

bool looksLikeZip(std::string_view bytes) {
  return bytes.starts_with(kLocalMark);
}

ZipArchive::ZipArchive(const FileBytes& file, std::uintmax_t maxUnpacked) : file_(file) {
  readDirectory(maxUnpacked);
}

void ZipArchive::readDirectory(std::uintmax_t maxUnpacked) {
  const std::string_view bytes = file_.text();
  const std::size_t end = bytes.rfind(kEndMark);
  if (end == std::string_view::npos || bytes.size() - end < kEndBytes || bytes.size() - end > kEndBytes + kMaxComment)
    fail("the zip directory is missing: the archive is truncated or damaged");
  std::uint64_t count = fieldAt<std::uint16_t>(bytes, end + 10);
  std::uint64_t at = fieldAt<std::uint32_t>(bytes, end + 16);
  if (at == kIn64 || count == kIn64Members) {
    const std::size_t large = bytes.rfind(kLargeEndMark, end);
    if (large == std::string_view::npos || bytes.size() - large < kLargeEndBytes)
      fail("the zip64 directory is missing");
    count = fieldAt<std::uint64_t>(bytes, large + 32);
    at = fieldAt<std::uint64_t>(bytes, large + 48);
  }
  std::uintmax_t total = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (at > bytes.size() || bytes.size() - at < kMemberBytes || bytes.substr(at, 4) != kMemberMark)
      fail("the zip directory cannot be read: the archive is truncated or damaged");
    const std::size_t nameBytes = fieldAt<std::uint16_t>(bytes, at + 28);
    const std::size_t extraBytes = fieldAt<std::uint16_t>(bytes, at + 30);
    if (bytes.size() - at - kMemberBytes < nameBytes + extraBytes) fail("the zip directory ends early");
    ZipMember member;
    member.name = bytes.substr(at + kMemberBytes, nameBytes);
    member.encrypted = (fieldAt<std::uint16_t>(bytes, at + 8) & kEncryptedFlag) != 0;
    member.method = fieldAt<std::uint16_t>(bytes, at + 10);
    member.checksum = fieldAt<std::uint32_t>(bytes, at + 16);
    member.packed = fieldAt<std::uint32_t>(bytes, at + 20);
    member.unpacked = fieldAt<std::uint32_t>(bytes, at + 24);
    member.offset = fieldAt<std::uint32_t>(bytes, at + 42);
    if (!takeLargeNumbers(bytes.substr(at + kMemberBytes + nameBytes, extraBytes), member))
      fail("a zip64 size is missing");
    // Compared one by one, the sum cannot overflow.
    if (member.unpacked > maxUnpacked || total + member.unpacked > maxUnpacked)
      fail("unpacks to " + std::to_string(member.unpacked > maxUnpacked ? member.unpacked : total + member.unpacked) +
           " bytes or more, at most " + std::to_string(maxUnpacked) + " are allowed");
    total += member.unpacked;
    at += kMemberBytes + nameBytes + extraBytes + fieldAt<std::uint16_t>(bytes, at + 32);
    members_.push_back(std::move(member));
  }
}

const ZipMember* ZipArchive::find(std::string_view name) const {
  if (name.starts_with('/')) name.remove_prefix(1);
  const std::string wanted = lowerCase(name);
  for (const ZipMember& member : members_)
    if (lowerCase(member.name) == wanted) return &member;
  return nullptr;
}

std::string ZipArchive::unpack(const ZipMember& member) const {
  const std::string_view bytes = file_.text();
  const std::string what = "the member " + inQuotes(member.name);
  if (member.encrypted) fail(what + " is encrypted");
  if (member.method != kStored && member.method != kDeflated)
    fail(what + " is packed by method " + std::to_string(member.method) + ", expected 0 or 8");
  const std::uint64_t at = member.offset;
  if (at > bytes.size() || bytes.size() - at < kLocalBytes || bytes.substr(at, 4) != kLocalMark)
    fail(what + " is not where it should be");
  const std::size_t head =
      kLocalBytes + fieldAt<std::uint16_t>(bytes, at + 26) + fieldAt<std::uint16_t>(bytes, at + 28);
  if (bytes.size() - at < head || bytes.size() - at - head < member.packed) fail(what + " is cut off");
  const std::string_view packed = bytes.substr(at + head, member.packed);
  std::string text;
  if (member.method == kStored) {
    text = packed;
  } else {
    text.resize(member.unpacked);
    if (!inflateInto(packed, text))
      fail(what + " does not unpack to the " + std::to_string(member.unpacked) + " bytes that it should have");
  }
  const auto checksum =
      static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
  if (text.size() != member.unpacked || checksum != member.checksum)
    fail(what + " does not have its checksum: it is damaged");
  return text;
}

void ZipArchive::fail(const std::string& what) const {
  throw InvalidInput(file_.path() + ": " + what);
}

}  // namespace vantage
