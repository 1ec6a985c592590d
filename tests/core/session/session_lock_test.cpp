#include "session/session_lock.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/io/expect_error.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;

TEST(SessionLock, KeepsOthersOutAsLongAsItLives) {
  const testing::TemporaryFolder folder;
  const std::string session = folder.file("a.vantage");
  {
    const SessionLock lock(session);
    expectError<IoError>([&] { const SessionLock second(session); }, {"a.vantage", "test_session"});
    const SessionLock other(folder.file("b.vantage"));
  }
  const SessionLock again(session);
  EXPECT_TRUE(std::filesystem::exists(session + ".lock"));
}

TEST(SessionLock, GoesWithWhatItIsMovedTo) {
  const testing::TemporaryFolder folder;
  const std::string session = folder.file("a.vantage");
  {
    SessionLock first(session);
    const SessionLock second(std::move(first));
    EXPECT_THROW(const SessionLock third(session), SessionInUse);
  }
  EXPECT_FALSE(std::filesystem::exists(session + ".lock"));
}

// What a program that was killed leaves behind hinders nobody.
TEST(SessionLock, AFileThatNobodyHoldsIsNoLock) {
  const testing::TemporaryFolder folder;
  folder.write("a.vantage.lock", "1 host program\n");
  const SessionLock lock(folder.file("a.vantage"));
  EXPECT_THROW(const SessionLock second(folder.file("a.vantage")), IoError);
}

TEST(SessionLock, SaysWhereItsFolderTakesNoFile) {
  const testing::TemporaryFolder folder;
  expectError<IoError>([&] { const SessionLock lock(folder.file("missing/a.vantage")); }, {"a.vantage", "folder"});
}

}  // namespace
}  // namespace vantage
