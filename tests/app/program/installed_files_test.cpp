#include "program/installed_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "program/user_folders.h"
#include "support/test_data.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

class InstalledFiles : public ::testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& path) const { return temporary_.file(path); }
  void makeProgram(const std::string& path) const {
    fs::create_directories(fs::path(at(path)).parent_path());
    temporary_.write(path, "#!/bin/sh\n");
    fs::permissions(at(path), fs::perms::owner_all);
  }

  testing::TemporaryFolder temporary_;
};

TEST_F(InstalledFiles, ResourcesAreTheOnesOfTheInstallationWhereverItIs) {
  fs::create_directories(at("usr/share/vantage/scanners"));
  EXPECT_EQ(resourceFolder("scanners", at("usr/bin/vantage-cli"), ""), at("usr/share/vantage/scanners"));
  fs::rename(at("usr"), at("elsewhere"));
  EXPECT_EQ(resourceFolder("scanners", at("elsewhere/bin/vantage-cli"), ""), at("elsewhere/share/vantage/scanners"));
  EXPECT_EQ(resourceFolder("", at("elsewhere/bin/vantage-cli"), ""), at("elsewhere/share/vantage"));
}

TEST_F(InstalledFiles, ResourcesAreBesideAProgramThatIsNotInstalled) {
  EXPECT_EQ(resourceFolder("scanners", at("build/bin/vantage-cli"), ""), at("build/bin/resources/scanners"));
  // Of this very build folder.
  EXPECT_TRUE(fs::exists(fs::path(resourceFolder("scanners")) / "rotating_stripe.json"));
  EXPECT_TRUE(fs::equivalent(resourceFolder("scanners"), testing::sourceFolder() / "resources" / "scanners"));
}

TEST_F(InstalledFiles, TheEnvironmentHasTheLastWord) {
  fs::create_directories(at("usr/share/vantage"));
  EXPECT_EQ(resourceFolder("scanners", at("usr/bin/vantage-cli"), "/mine"), "/mine/scanners");
}

TEST_F(InstalledFiles, HelpersAreFoundInstalledAndInTheBuildFolder) {
  EXPECT_FALSE(helperProgram("vantage-pictures", at("usr/bin/vantage-cli")));
  makeProgram("build/bin/vantage-pictures");
  EXPECT_EQ(helperProgram("vantage-pictures", at("build/bin/vantage-cli")), fs::path(at("build/bin/vantage-pictures")));
  makeProgram("usr/libexec/vantage/vantage-pictures");
  EXPECT_EQ(helperProgram("vantage-pictures", at("usr/bin/vantage-cli")),
            fs::path(at("usr/libexec/vantage/vantage-pictures")));
}

TEST_F(InstalledFiles, AFileThatMayNotBeRunIsNoHelper) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may run what anybody may run";
  makeProgram("usr/libexec/vantage/vantage-pictures");
  fs::permissions(at("usr/libexec/vantage/vantage-pictures"), fs::perms::owner_read);
  EXPECT_FALSE(helperProgram("vantage-pictures", at("usr/bin/vantage-cli")));
}

TEST_F(InstalledFiles, ThisProgramKnowsItsFile) {
  EXPECT_EQ(programFile().filename(), "test_program");
}

TEST(UserFolders, FollowTheEnvironment) {
  ASSERT_EQ(::setenv("XDG_STATE_HOME", "/s", 1), 0);
  ASSERT_EQ(::setenv("XDG_CACHE_HOME", "/c", 1), 0);
  EXPECT_EQ(stateDirectory(), "/s/vantage");
  EXPECT_EQ(cacheDirectory(), "/c/vantage");
  ASSERT_EQ(::unsetenv("XDG_STATE_HOME"), 0);
  ASSERT_EQ(::unsetenv("XDG_CACHE_HOME"), 0);
  ASSERT_EQ(::setenv("HOME", "/h", 1), 0);
  EXPECT_EQ(stateDirectory(), "/h/.local/state/vantage");
  EXPECT_EQ(cacheDirectory(), "/h/.cache/vantage");
}

}  // namespace
}  // namespace vantage
