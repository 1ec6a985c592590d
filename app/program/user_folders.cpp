#include "program/user_folders.h"

#include <cstdlib>

namespace vantage {
namespace {

std::string folderOf(const char* variable, const char* belowHome) {
  if (const char* folder = std::getenv(variable); folder != nullptr && *folder != 0)
    return std::string(folder) + "/vantage";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0)
    return std::string(home) + belowHome + "/vantage";
  return {};
}

}  // namespace

std::string cacheDirectory() {
  return folderOf("XDG_CACHE_HOME", "/.cache");
}

std::string stateDirectory() {
  return folderOf("XDG_STATE_HOME", "/.local/state");
}

}  // namespace vantage
