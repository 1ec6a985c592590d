#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vantage::testing {

/// `value` as little endian bytes.
inline std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += i < 8 ? static_cast<char>(value >> (8 * i) & 0xff) : '\0';
  return text;
}

/// Raw deflate.
inline std::string deflated(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// A zip archive of members that are deflated; for a test of lies, every unpacked size can be declared otherwise.
inline std::string zipOf(const std::vector<std::pair<std::string, std::string>>& members,
                         std::uint64_t declaredSize = 0) {
  std::string archive;
  std::string directory;
  for (const auto& [name, text] : members) {
    const std::string packed = deflated(text);
    const auto checksum = crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
    const std::string common = littleEndian(8, 2) + littleEndian(0, 4) + littleEndian(checksum, 4) +
                               littleEndian(packed.size(), 4) +
                               littleEndian(declaredSize > 0 ? declaredSize : text.size(), 4) +
                               littleEndian(name.size(), 2) + littleEndian(0, 2);
    directory += "PK\x01\x02" + littleEndian(20, 2) + littleEndian(20, 2) + littleEndian(0, 2) + common +
                 littleEndian(0, 10) + littleEndian(archive.size(), 4) + name;
    archive += "PK\x03\x04" + littleEndian(20, 2) + littleEndian(0, 2) + common + name + packed;
  }
  const std::string end = "PK\x05\x06" + littleEndian(0, 4) + littleEndian(members.size(), 2) +
                          littleEndian(members.size(), 2) + littleEndian(directory.size(), 4) +
                          littleEndian(archive.size(), 4) + littleEndian(0, 2);
  return archive + directory + end;
}

}  // namespace vantage::testing
