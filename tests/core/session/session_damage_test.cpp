#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/random.h"
#include "session/database.h"
#include "session/loss.h"
#include "session/session.h"
#include "session/session_blobs.h"
#include "session/session_schema.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::createSmallSession;
using testing::runSmallSession;
using testing::TemporaryFolder;

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The loss of a kind; none of that kind is a failure.
Loss theLoss(const std::vector<Loss>& losses, LossKind kind) {
  const auto at = std::find_if(losses.begin(), losses.end(), [&](const Loss& loss) { return loss.kind == kind; });
  EXPECT_NE(at, losses.end()) << "kind " << static_cast<int>(kind);
  return at == losses.end() ? Loss{} : *at;
}

class SessionDamage : public ::testing::Test {
 protected:
  void SetUp() override {
    AcquisitionSettings settings;
    settings.maxViews = 3;
    Session session = createSmallSession(path(), settings);
    saved_ = runSmallSession(session);
  }
  [[nodiscard]] std::string path() const { return folder_.file("test.vantage"); }
  void change(const std::string& sql) const { Database(path(), Database::Mode::Write).run(sql); }

  TemporaryFolder folder_;
  AcquisitionState saved_;
};

TEST_F(SessionDamage, ModelsThatAreLostAreMadeAgainToTheSameBytes) {
  change("DELETE FROM model");
  const Session session = Session::open(path(), SessionAccess::Read);
  EXPECT_EQ(modelBlob(*session.state()->model), modelBlob(*saved_.model));
  EXPECT_EQ(stateHash(*session.state(2)), session.history().entry(2).hash);
  EXPECT_TRUE(session.losses().empty());
}

TEST_F(SessionDamage, ADamagedModelIsMadeAgainAndNamed) {
  change("UPDATE model SET data = x'00112233' WHERE step = (SELECT max(step) FROM model)");
  const Session session = Session::open(path(), SessionAccess::Read);
  EXPECT_EQ(modelBlob(*session.state()->model), modelBlob(*saved_.model));
  const Loss loss = theLoss(session.losses(), LossKind::ModelDamaged);
  EXPECT_EQ(loss.number, 4);
  EXPECT_NE(loss.error.find("model 4"), std::string::npos) << loss.error;
}

TEST_F(SessionDamage, AScanThatIsLostIsNamedAndTheOthersAreThere) {
  change("UPDATE scan SET range = x'00112233' WHERE id = 1");
  const Session session = Session::open(path(), SessionAccess::Read);
  const auto state = session.state();
  ASSERT_EQ(countScans(*state, ScanStatus::In), 2U);
  EXPECT_EQ(state->scans[1].number, 2);
  EXPECT_TRUE(state->model);
  const Loss loss = theLoss(session.losses(), LossKind::ScanDamaged);
  EXPECT_EQ(loss.number, 1);
  EXPECT_NE(loss.error.find("scan 1"), std::string::npos) << loss.error;
}

TEST_F(SessionDamage, IsCopiedBeforeAnythingIsWritten) {
  change("UPDATE scan SET range = x'00112233' WHERE id = 1");
  const std::string before = bytesOf(path());
  {
    const Session reader = Session::open(path(), SessionAccess::Read);
    EXPECT_FALSE(std::filesystem::exists(path() + ".damaged-1"));
  }
  Session session = Session::open(path(), SessionAccess::Write);
  EXPECT_EQ(bytesOf(path() + ".damaged-1"), before);
  EXPECT_EQ(theLoss(session.losses(), LossKind::Copied).name, path() + ".damaged-1");
  session.setNote("page", "review");
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 2U);
}

TEST_F(SessionDamage, AnObjectWithoutItsMeshAndAProfileThatIsLostAreSaid) {
  change("UPDATE object SET mesh = NULL");
  {
    Database database(path(), Database::Mode::Write);
    addSums(database, "object");
    database.run("DELETE FROM file");
  }
  const Session session = Session::open(path(), SessionAccess::Read);
  try {
    static_cast<void>(session.object());
    FAIL() << "there is no object";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("profile is lost"), std::string::npos) << e.what();
  }
}

// Pages in the middle of the file are overwritten one at a time.
TEST_F(SessionDamage, OpensAsFarAsItIsReadable) {
  const std::string good = bytesOf(path());
  // At 16, big-endian (SQLite's file format, 1.3.2).
  const std::size_t size = static_cast<unsigned char>(good[16]) * 256U + static_cast<unsigned char>(good[17]);
  const std::size_t pages = good.size() / size;
  ASSERT_GT(pages, 10U);
  Random random(3);
  int opened = 0;
  constexpr int kTries = 40;
  for (int i = 0; i < kTries; ++i) {
    std::string bad = good;
    const std::size_t page = 1 + random.below(pages - 1);
    std::fill_n(bad.begin() + static_cast<std::ptrdiff_t>(page * size), size, static_cast<char>(random.below(256)));
    std::ofstream(path(), std::ios::binary) << bad;
    try {
      const Session session = Session::open(path(), i % 2 == 0 ? SessionAccess::Read : SessionAccess::Write);
      const bool whole = stateHash(*session.state()) == stateHash(saved_);
      EXPECT_TRUE(whole || !session.losses().empty()) << "page " << page;
      ++opened;
    } catch (const Error&) {
      // Page 0 is not the only one without which nothing can be read.
    }
    for (const auto& file : std::filesystem::directory_iterator(std::filesystem::path(path()).parent_path()))
      std::filesystem::remove(file);
  }
  EXPECT_GE(opened, kTries * 3 / 4);
}

TEST_F(SessionDamage, AFileThatWasCutIsReadAsFarAsItGoesOrRefused) {
  const std::string good = bytesOf(path());
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    std::ofstream(path(), std::ios::binary) << good.substr(0, random.below(good.size()));
    try {
      static_cast<void>(Session::open(path(), SessionAccess::Read).state());
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("test.vantage"), std::string::npos) << e.what();
    }
  }
}

// A file as version 1 wrote it after two views.
void writeVersion1(const std::string& path, const AcquisitionState& state) {
  Database database(path, Database::Mode::Create);
  for (const char* table :
       {"meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID",
        "file(name TEXT PRIMARY KEY, content TEXT NOT NULL) WITHOUT ROWID",
        "rays(id INTEGER PRIMARY KEY, rows INTEGER NOT NULL, columns INTEGER NOT NULL, receivers INTEGER NOT NULL, "
        "data "
        "BLOB NOT NULL)",
        "scan(id INTEGER PRIMARY KEY, position INTEGER NOT NULL, rays INTEGER REFERENCES rays(id), nominal BLOB NOT "
        "NULL, range BLOB NOT NULL)",
        "view(id INTEGER PRIMARY KEY, scan INTEGER NOT NULL REFERENCES scan(id), pose BLOB NOT NULL, samples INTEGER "
        "NOT NULL, triangles INTEGER NOT NULL)",
        "model(id INTEGER PRIMARY KEY CHECK (id = 1), data BLOB NOT NULL)"})
    database.run(std::string("CREATE TABLE ") + table);
  database.run(
      "INSERT INTO meta VALUES('schema', '1'), ('object', 'small'), ('placement', 'as-is'), ('seed', '1'), "
      "('ideal', '0'), ('first_view', '0'), ('max_views', '3'), ('tolerance', '0'), ('strategy', 'ps')");
  database.prepare("INSERT INTO file VALUES('profile.json', ?)")
      .bind(1, std::string_view(testing::smallProfileSource().text))
      .run();
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(countScans(state, ScanStatus::In)); ++i) {
    const View& view = state.scans[static_cast<std::size_t>(i)].view;
    database.prepare("INSERT INTO scan VALUES(?, ?, NULL, ?, ?)")
        .bind(1, i)
        .bind(2, std::int64_t{view.image->station.position.value()})
        .bind(3, std::span<const std::byte>(poseBlob(view.image->T_table_scanner)))
        .bind(4, std::span<const std::byte>(rangeBlob(view.image->range)))
        .run();
    database.prepare("INSERT INTO view VALUES(?, ?, ?, 10, 20)")
        .bind(1, i)
        .bind(2, i)
        .bind(3, std::span<const std::byte>(poseBlob(view.T_object_scanner)))
        .run();
  }
  database.prepare("INSERT INTO model VALUES(1, ?)").bind(1, std::span<const std::byte>(modelBlob(*state.model))).run();
}

TEST_F(SessionDamage, AFileOfTheFirstVersionIsBroughtUpToDateAndGoesOn) {
  writeVersion1(path(), *Session::open(path(), SessionAccess::Read).state(2));
  // The same acquisition with what such a file means by its settings, not interrupted.
  const AcquisitionSettings settings = Session::open(path(), SessionAccess::Read).state()->settings;
  Session whole = createSmallSession(folder_.file("whole.vantage"), settings);
  const AcquisitionState last = runSmallSession(whole);
  const AcquisitionState two = *whole.state(2);
  writeVersion1(path(), two);
  EXPECT_EQ(modelBlob(*Session::open(path(), SessionAccess::Read).state()->model), modelBlob(*two.model));
  Session session = Session::open(path(), SessionAccess::Write);
  ASSERT_EQ(countScans(*session.state(), ScanStatus::In), 2U);
  EXPECT_EQ(session.state()->settings.maxViews, 3);
  EXPECT_EQ(session.state()->scans[0].record.samples, 10U);
  runSmallSession(session);
  EXPECT_EQ(modelBlob(*session.state()->model), modelBlob(*last.model));
}

}  // namespace
}  // namespace vantage
