#include "program/version.h"

#include <algorithm>
#include <sstream>

#include "program/commit.h"

namespace vantage {

std::string programVersion() {
  return VANTAGE_VERSION;
}

std::string programCommit() {
  return kCommit;
}

std::vector<UsedLibrary> usedLibraries() {
  std::vector<UsedLibrary> libraries;
  std::istringstream list{std::string(VANTAGE_LIBRARIES)};
  for (std::string entry; std::getline(list, entry, '|');)
    if (const auto space = entry.rfind(' '); space != std::string::npos)
      libraries.push_back({entry.substr(0, space), entry.substr(space + 1)});
  std::sort(libraries.begin(), libraries.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return libraries;
}

std::string versionText(const std::string& program) {
  std::string text =
      program + " " + programVersion() + "\ncommit " + programCommit() + "\nbuilt with " + VANTAGE_COMPILER;
  for (const UsedLibrary& library : usedLibraries()) text += "\n  " + library.name + " " + library.version;
  return text;
}

}  // namespace vantage
