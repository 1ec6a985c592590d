#include "house/untested_headers.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <set>

#include "house/source_files.h"

namespace vantage::testing {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> kTestedRooms{"planning", "acquisition", "session"};

// What the tests of a room include: "room/header.h".
std::set<std::string> includesOfTests(const fs::path& folder) {
  static const std::regex kInclude("^#include \"([^\"]+)\"");
  std::set<std::string> includes;
  if (!fs::is_directory(folder)) return includes;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.path().filename().string().ends_with("_test.cpp")) continue;
    std::ifstream in(entry.path());
    std::smatch match;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, match, kInclude)) includes.insert(match[1].str());
  }
  return includes;
}

}  // namespace

std::vector<std::string> untestedHeaders(const fs::path& root) {
  std::vector<std::string> untested;
  const std::vector<SourceFile> files = sourceFiles(root);
  for (const char* room : kTestedRooms) {
    const std::set<std::string> includes = includesOfTests(root / "tests/core" / room);
    const std::string folder = std::string("core/") + room;
    for (const SourceFile& file : files)
      if (file.isHeader() && file.folder() == folder &&
          !includes.contains(file.name.substr(std::string("core/").size())))
        untested.push_back(file.name);
  }
  std::sort(untested.begin(), untested.end());
  return untested;
}

}  // namespace vantage::testing
