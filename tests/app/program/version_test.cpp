#include "program/version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace vantage {
namespace {

TEST(Version, NamesTheCommitOrSaysThatItIsUnknown) {
  EXPECT_TRUE(std::regex_match(programCommit(), std::regex("[0-9a-f]{12}(-modified)?|unknown"))) << programCommit();
}

TEST(Version, ListsTheLibrariesByName) {
  const std::vector<UsedLibrary> libraries = usedLibraries();
  EXPECT_TRUE(
      std::is_sorted(libraries.begin(), libraries.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const char* name : {"Eigen", "Embree", "OpenMesh", "Qhull", "Assimp", "SQLite", "Zstandard"})
    EXPECT_TRUE(std::any_of(libraries.begin(), libraries.end(), [&](const auto& l) { return l.name == name; })) << name;
  for (const UsedLibrary& library : libraries)
    EXPECT_TRUE(std::regex_search(library.version, std::regex("^[0-9]+\\.[0-9]")))
        << library.name << " " << library.version;
}

TEST(Version, IsOneLinePerFact) {
  const std::string text = versionText("vantage-cli");
  EXPECT_TRUE(text.starts_with("vantage-cli " + programVersion() + "\ncommit " + programCommit() + "\n"));
  for (const UsedLibrary& library : usedLibraries())
    EXPECT_NE((text + "\n").find("\n  " + library.name + " " + library.version + "\n"), std::string::npos)
        << library.name;
}

}  // namespace
}  // namespace vantage
