#include "cli/cache_directory.h"

#include <cstdlib>

namespace vantage {

std::string cacheDirectory() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != 0)
    return std::string(cache) + "/vantage";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0)
    return std::string(home) + "/.cache/vantage";
  return {};
}

}  // namespace vantage
