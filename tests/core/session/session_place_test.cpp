#include "session/session_place.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "base/errors.h"
#include "core/io/expect_error.h"
#include "io/file_bytes.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::filesBelow;
using testing::TemporaryFolder;

const SessionStart kEmpty{std::nullopt, {}, nullptr, nullptr};

class SessionPlaceTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("mug.vantage"); }
  [[nodiscard]] std::size_t files() const { return filesBelow(folder_.file(".")).size(); }

  // A session with a remark by which it is known again.
  void makeOld() {
    Session session = Session::create(path(), kEmpty);
    session.setNote("page", "the old one");
  }
  [[nodiscard]] std::string noteAt(const std::string& file) const {
    return Session::open(file, SessionAccess::Read).note("page");
  }

  TemporaryFolder folder_;
};

TEST_F(SessionPlaceTest, TakenByASessionIsRefused) {
  makeOld();
  expectError<InvalidInput>([&] { const SessionPlace place(path(), false); }, {path(), "resume", "--replace"});
  expectError<IoError>([&] { static_cast<void>(Session::create(path(), kEmpty)); }, {path(), "is there already"});
  EXPECT_EQ(noteAt(path()), "the old one");
}

TEST_F(SessionPlaceTest, TakenByAnythingElseIsRefusedEvenToReplace) {
  const std::string scan = folder_.write("scan.ply", "ply\n");
  expectError<InvalidInput>([&] { const SessionPlace place(scan, true); }, {scan, "no session"});
  std::filesystem::create_directory(folder_.file("folder"));
  EXPECT_THROW(const SessionPlace place(folder_.file("folder"), true), InvalidInput);
  EXPECT_THROW(static_cast<void>(Session::create(scan, kEmpty)), IoError);
  EXPECT_EQ(FileBytes(scan).text(), "ply\n");
}

TEST_F(SessionPlaceTest, ReplacedOnceTheNewSessionIsWhole) {
  makeOld();
  SessionPlace place(path(), true);
  std::optional<Session> session(place.make(kEmpty));
  session.reset();
  place.keep();
  EXPECT_EQ(files(), 1U);
  EXPECT_EQ(noteAt(path()), "");
}

TEST_F(SessionPlaceTest, GivesTheOldSessionBackWhenTheNewOneFails) {
  makeOld();
  {
    SessionPlace place(path(), true);
    const Session session = place.make(kEmpty);
  }
  EXPECT_EQ(files(), 1U);
  EXPECT_EQ(noteAt(path()), "the old one");
}

TEST_F(SessionPlaceTest, LeavesNothingOfANewSessionThatFails) {
  {
    SessionPlace place(path(), false);
    const Session session = place.make(kEmpty);
  }
  EXPECT_EQ(files(), 0U);
}

TEST_F(SessionPlaceTest, KeepsBothWhenTheNewOneCanBeGoneOnWith) {
  makeOld();
  std::string aside;
  {
    SessionPlace place(path(), true);
    const Session session = place.make(kEmpty);
    place.release();
    aside = place.aside().value();
  }
  EXPECT_EQ(noteAt(path()), "");
  EXPECT_EQ(noteAt(aside), "the old one");
}

TEST_F(SessionPlaceTest, NeverReplacesASessionThatIsBeingWritten) {
  const Session session = Session::create(path(), kEmpty);
  EXPECT_THROW(const SessionPlace place(path(), true), IoError);
  EXPECT_TRUE(std::filesystem::exists(path()));
}

}  // namespace
}  // namespace vantage
