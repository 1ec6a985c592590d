#include "devices/resource_folder.h"

#include <cstdlib>
#include <filesystem>

namespace vantage {
namespace {

namespace fs = std::filesystem;

fs::path root() {
  if (const char* named = std::getenv("VANTAGE_RESOURCES"); named != nullptr && *named != '\0') return named;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path installed = program.parent_path().parent_path() / "share" / "vantage";
  if (!unknown && fs::is_directory(installed, unknown)) return installed;
  return VANTAGE_RESOURCES;
}

}  // namespace

std::string resourceFolder(const std::string& name) {
  return (root() / name).string();
}

}  // namespace vantage
