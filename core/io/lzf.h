#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vantage {

/// Unpacks a block of LZF, the compression of binary_compressed PCD files. Memory grows with what is really there.
/// @param size of what comes out.
/// @throws InvalidInput beginning with `what` when the block is damaged or has another size.
[[nodiscard]] std::string unpackLzf(std::string_view packed, std::size_t size, const std::string& what);

}  // namespace vantage
