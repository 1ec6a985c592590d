#include "support/test_data.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>

namespace vantage::testing {

namespace fs = std::filesystem;

std::optional<fs::path> testDataFolder() {
  const char* named = std::getenv("VANTAGE_TEST_DATA");
  const fs::path folder = named != nullptr ? fs::path(named) : sourceFolder().parent_path() / "shared" / "data";
  return fs::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

fs::path sourceFolder() {
  return VANTAGE_SOURCE_DIR;
}

std::vector<std::string> filesBelow(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> next{0};
  path_ = fs::temp_directory_path() / ("vantage-test-" + std::to_string(::getpid()) + "-" + std::to_string(next++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
  std::string path = file(name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

}  // namespace vantage::testing
