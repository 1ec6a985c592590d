#pragma once

#include <string>

namespace vantage {

/// The other program that has a device file open, "screen (process 4711)"; empty when none is seen. Programs of other
/// users are only seen by root, or when they lock the port in /run/lock.
[[nodiscard]] std::string holderOf(const std::string& path);

}  // namespace vantage
