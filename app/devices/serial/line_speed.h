#pragma once

namespace vantage {

/// Sets an open serial port to raw bytes (8 data bits, no parity, one stop bit, no flow control) at a speed [bit/s],
/// which may be one that POSIX has no name for.
/// @return 0, or the errno of what failed
[[nodiscard]] int makeRaw(int descriptor, int baud);

}  // namespace vantage
