#pragma once

#include <cstdint>
#include <string_view>

#include "io/file_bytes.h"

namespace vantage {

[[nodiscard]] bool looksLikeZip(std::string_view bytes);

/// The size that all members of a zip archive say they have unpacked, from its central directory [bytes].
/// @throws InvalidInput naming the file when the archive has no readable directory: it is truncated or damaged.
[[nodiscard]] std::uintmax_t unpackedBytes(const FileBytes& file);

}  // namespace vantage
