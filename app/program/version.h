#pragma once

#include <string>
#include <vector>

namespace vantage {

/// "0.1.0"
[[nodiscard]] std::string programVersion();

/// The commit that the program was built from, with "-modified" where the sources were not as committed; "unknown"
/// where they were no repository.
[[nodiscard]] std::string programCommit();

/// A library, and the version of it that the program was built with.
struct UsedLibrary {
  std::string name;
  std::string version;
};

/// The libraries that the programs were built with, by name. Libraries of the window are not among them where it was
/// not built.
[[nodiscard]] std::vector<UsedLibrary> usedLibraries();

/// What --version prints: "vantage-cli 0.1.0", the commit, the compiler and the libraries, one to a line, without an
/// end of line after the last.
[[nodiscard]] std::string versionText(const std::string& program);

}  // namespace vantage
