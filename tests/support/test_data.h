#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vantage::testing {

/// The folder of real scans and damaged files, which is not part of the project: the environment variable
/// VANTAGE_TEST_DATA, else shared/data beside the source tree. Nothing when it is absent.
[[nodiscard]] std::optional<std::filesystem::path> testDataFolder();

/// The project's source tree.
[[nodiscard]] std::filesystem::path sourceFolder();

/// All files below a folder, sorted by name.
[[nodiscard]] std::vector<std::string> filesBelow(const std::filesystem::path& folder);

/// A folder of its own below the temporary folder, removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file into the folder. @return its path
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  std::filesystem::path path_;
};

}  // namespace vantage::testing

/// Leaves a test that needs the folder of test data where there is none.
// NOLINTBEGIN(bugprone-macro-parentheses): the name that it declares
#define VANTAGE_NEEDS_TEST_DATA(folder)                     \
  const auto folder = ::vantage::testing::testDataFolder(); \
  if (!folder) GTEST_SKIP() << "no test data: set VANTAGE_TEST_DATA to the folder that holds it"
// NOLINTEND(bugprone-macro-parentheses)
