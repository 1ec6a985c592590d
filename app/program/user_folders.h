#pragma once

#include <string>

namespace vantage {

/// Where computed images of scanners are kept between runs ($XDG_CACHE_HOME/vantage or ~/.cache/vantage); empty when
/// the machine names no such place.
[[nodiscard]] std::string cacheDirectory();

/// Where what broke is kept ($XDG_STATE_HOME/vantage or ~/.local/state/vantage); empty when the machine names no such
/// place.
[[nodiscard]] std::string stateDirectory();

}  // namespace vantage
