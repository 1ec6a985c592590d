#include "io/zip_writer.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little, "zip fields are copied as they are");

constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint16_t kVersion = 20;  // 2.0: deflate
constexpr std::uint16_t kDeflated = 8;
constexpr std::uint16_t kNoTime = 0;
constexpr std::uint16_t kNoDate = 0x0021;  // the first that there is: 1 January 1980
constexpr int kMemoryLevel = 8;            // as zlib itself has it
constexpr std::size_t kBuffer = 1U << 16;

template <typename T>
void put(std::string& to, T value) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(T));
  to.append(bytes.data(), bytes.size());
}

// What local header and directory have in common (4.3.7 and 4.3.12).
void putMember(std::string& to, const std::string& name, std::uint32_t checksum, std::uint64_t packed,
               std::uint64_t unpacked) {
  put(to, kVersion);
  put<std::uint16_t>(to, 0);  // flags
  put(to, kDeflated);
  put(to, kNoTime);
  put(to, kNoDate);
  put(to, checksum);
  put(to, static_cast<std::uint32_t>(packed));
  put(to, static_cast<std::uint32_t>(unpacked));
  put(to, static_cast<std::uint16_t>(name.size()));
  put<std::uint16_t>(to, 0);  // extra fields
}

}  // namespace

struct PackedMember::Stream {
  Stream() {
    if (::deflateInit2(&zlib, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Stream() { ::deflateEnd(&zlib); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  z_stream zlib{};
};

PackedMember::PackedMember(std::string name) : name_(std::move(name)), stream_(std::make_unique<Stream>()) {}
PackedMember::~PackedMember() = default;
PackedMember::PackedMember(PackedMember&&) noexcept = default;
PackedMember& PackedMember::operator=(PackedMember&&) noexcept = default;

void PackedMember::write(std::string_view text) {
  pack(text, false);
}

void PackedMember::pack(std::string_view text, bool last) {
  // Without bytes zlib would begin the sum anew.
  if (!text.empty())
    checksum_ =
        static_cast<std::uint32_t>(::crc32_z(checksum_, reinterpret_cast<const Bytef*>(text.data()), text.size()));
  unpacked_ += text.size();
  z_stream& zlib = stream_->zlib;
  // zlib does not write to its input.
  zlib.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  zlib.avail_in = static_cast<uInt>(text.size());
  std::array<char, kBuffer> buffer;
  do {
    zlib.next_out = reinterpret_cast<Bytef*>(buffer.data());
    zlib.avail_out = static_cast<uInt>(buffer.size());
    ::deflate(&zlib, last ? Z_FINISH : Z_NO_FLUSH);
    packed_.append(buffer.data(), buffer.size() - zlib.avail_out);
  } while (zlib.avail_out == 0);
}

void ZipWriter::add(PackedMember member) {
  member.pack({}, true);
  std::string local("PK\x03\x04", 4);
  putMember(local, member.name_, member.checksum_, member.packed_.size(), member.unpacked_);
  local += member.name_;
  const std::uint64_t end = at_ + local.size() + member.packed_.size();
  if (end > kLargest || member.unpacked_ > kLargest)
    throw InvalidInput("the archive would become larger than 4 GB: fewer triangles, or another format, are needed");
  directory_.append("PK\x01\x02", 4);
  put(directory_, kVersion);
  putMember(directory_, member.name_, member.checksum_, member.packed_.size(), member.unpacked_);
  put<std::uint16_t>(directory_, 0);  // comment
  put<std::uint16_t>(directory_, 0);  // disk
  put<std::uint16_t>(directory_, 0);  // internal attributes
  put<std::uint32_t>(directory_, 0);  // external attributes
  put(directory_, static_cast<std::uint32_t>(at_));
  directory_ += member.name_;
  ++members_;
  writePieces(local);
  writePieces(member.packed_);
  at_ = end;
}

void ZipWriter::finish() {
  std::string end("PK\x05\x06", 4);
  put<std::uint16_t>(end, 0);  // disk
  put<std::uint16_t>(end, 0);  // disk of the directory
  put(end, members_);
  put(end, members_);
  put(end, static_cast<std::uint32_t>(directory_.size()));
  put(end, static_cast<std::uint32_t>(at_));
  put<std::uint16_t>(end, 0);  // comment
  writePieces(directory_);
  writePieces(end);
}

void ZipWriter::writePieces(std::string_view bytes) {
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), AtomicFile::kMaxPiece)))
    file_.write(bytes.substr(0, AtomicFile::kMaxPiece));
}

}  // namespace vantage
