#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

enum class PlyFormat { Ascii, BinaryLittleEndian, BinaryBigEndian };
enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a value in a binary file.
[[nodiscard]] std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> listCount;  ///< the type of the list's length; nothing for a scalar

  [[nodiscard]] bool isList() const { return listCount.has_value(); }
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] const PlyProperty* find(std::string_view property) const;
  [[nodiscard]] bool hasLists() const;
  /// Bytes of a row with empty lists in a binary file: the least that a row takes.
  [[nodiscard]] std::size_t leastRowBytes() const;
};

/// What a PLY file says about itself.
struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> objInfo;  ///< the texts of the obj_info lines
  std::vector<std::string> comments;
  std::size_t bodyOffset = 0;  ///< where the first row begins [bytes]
  std::size_t bodyLine = 0;    ///< and the number of its line

  [[nodiscard]] const PlyElement* find(std::string_view element) const;
  /// The value of the line `obj_info key value`.
  [[nodiscard]] std::optional<std::string> info(std::string_view key) const;
};

/// No header is longer; what goes on is not one.
inline constexpr std::size_t kMaxPlyHeaderBytes = 1U << 20;

[[nodiscard]] bool looksLikePly(std::string_view bytes);

/// Reads the header strictly: every line must be one of the format's, every element must be named once, every property
/// once in its element. comment and obj_info may stand anywhere; lines may end with LF, CR LF or CR.
/// @param bytes the beginning of the file, at least its header or its first kMaxPlyHeaderBytes.
/// @param fileSize of the whole file [bytes].
/// @param path for messages.
/// @throws InvalidInput naming file, line and what was expected; also when the counts need more bytes than there are.
[[nodiscard]] PlyHeader parsePlyHeader(std::string_view bytes, std::size_t fileSize, const std::string& path);

/// The header of a file of which nothing else is read.
/// @throws IoError, InvalidInput
[[nodiscard]] PlyHeader readPlyHeader(const std::string& path);

}  // namespace vantage
