#include "session/session_store.h"

#include <gtest/gtest.h>

#include "core/io/expect_error.h"
#include "session/session_json.h"
#include "session/session_schema.h"
#include "session/stored_history.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

using testing::expectError;

// Tables in memory, as a new session has them.
SessionStore emptyStore() {
  Database database = Database::inMemory("store.vantage");
  createSessionTables(database);
  return SessionStore(std::move(database));
}

HistoryEntry settingsEntry(std::int64_t step, int maxViews) {
  HistoryEntry entry;
  AcquisitionState state;
  state.settings.maxViews = maxViews;
  entry.step = step;
  entry.command = ChangeSettings{state.settings};
  entry.outline = std::make_shared<const StateOutline>(outlineOf(state));
  entry.hash = 0xfedcba9876543210ULL;
  return entry;
}

TEST(SessionStore, BringsBackTheProfileWithTheFilesThatItNames) {
  SessionStore store = emptyStore();
  EXPECT_FALSE(store.profileSource());
  ProfileSource source = testing::smallProfileSource();
  source.attachments["rays.txt"] = "1 2 3";
  store.setProfileSource(source);
  const auto read = store.profileSource();
  ASSERT_TRUE(read);
  EXPECT_EQ(read->text, source.text);
  EXPECT_EQ(read->attachments, source.attachments);
}

TEST(SessionStore, NumbersStepsAndKeepsTheirHashToTheLastBit) {
  SessionStore store = emptyStore();
  EXPECT_EQ(store.nextStep(), 1);
  store.addStep(settingsEntry(1, 3), 0, {});
  store.addStep(settingsEntry(2, 4), 1, {});
  EXPECT_EQ(store.nextStep(), 3);
  const StoredHistory history = store.history();
  ASSERT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.cursor, 1U);
  EXPECT_EQ(history.entries[1].hash, 0xfedcba9876543210ULL);
  EXPECT_EQ(history.entries[1].outline->settings.maxViews, 4);
  EXPECT_TRUE(history.losses.empty());
}

TEST(SessionStore, AScanOfNoPositionStaysOne) {
  SessionStore store = emptyStore();
  EXPECT_FALSE(store.lastStation());
  RangeImage image;
  image.rays = testing::smallProfile()->rays;
  image.range.assign(image.rays->size(), 0.0F);
  image.station.position.reset();
  image.poseKnownBy = PoseSource::Reported;
  EXPECT_EQ(store.addScan(image, 0), 0);
  image.station.position = 7;
  EXPECT_EQ(store.addScan(image, 0), 1);
  EXPECT_FALSE(store.scan(0, testing::smallProfile()->rays->size()).station.position);
  EXPECT_EQ(store.scan(0, testing::smallProfile()->rays->size()).poseKnownBy, PoseSource::Reported);
  EXPECT_EQ(store.scan(1, testing::smallProfile()->rays->size()).station.position, 7);
  ASSERT_TRUE(store.lastStation());
  EXPECT_EQ(store.lastStation()->position, 7);
  EXPECT_FALSE(store.scanUsed(1));
}

// Where a step is cut off by undo, the steps of the branch that holds are the history.
TEST(StoredHistory, FollowsTheBranchThatEndsAtTheTip) {
  SessionStore store = emptyStore();
  store.addStep(settingsEntry(1, 1), 0, {});
  store.addStep(settingsEntry(2, 2), 1, {});
  store.addStep(settingsEntry(3, 3), 1, {});
  StoredHistory history = readHistory(store.database(), 3, 3);
  ASSERT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.entries[1].step, 3);
  history = readHistory(store.database(), 2, 1);
  ASSERT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.entries[1].step, 2);
  EXPECT_EQ(history.cursor, 0U);
}

TEST(StoredHistory, NamesAStepThatIsLostAndGoesOnWithThoseBefore) {
  SessionStore store = emptyStore();
  for (int step = 1; step <= 3; ++step) store.addStep(settingsEntry(step, step), step - 1, {});
  store.database().run("DELETE FROM step WHERE id = 3");
  const StoredHistory history = readHistory(store.database(), 3, 3);
  ASSERT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.cursor, 1U);
  EXPECT_EQ(history.losses, (std::vector<Loss>{{LossKind::LastStepLost, 3, {}, {}}}));
}

TEST(SessionSchema, KnowsItsVersionsApart) {
  for (int version = 1; version <= kSessionSchema; ++version) {
    Database database = Database::inMemory("schema.vantage");
    createSessionTables(database, version);
    EXPECT_EQ(checkSessionTables(database), version);
    EXPECT_EQ(sessionTables(version).front(), "meta");
  }
}

TEST(SessionSchema, ASessionOfTheFutureSaysSo) {
  Database database = Database::inMemory("future.vantage");
  createSessionTables(database);
  database.run("UPDATE meta SET value = '" + std::to_string(kSessionSchema + 1) + "' WHERE key = 'schema'");
  database.run("CREATE TABLE more(x)");
  expectError<InvalidInput>([&] { static_cast<void>(checkSessionTables(database)); },
                            {"future.vantage", "schema " + std::to_string(kSessionSchema + 1), "newer version"});
}

TEST(Database, ATransactionThatIsNotCommittedDidNotHappen) {
  Database database = Database::inMemory("base");
  database.run("CREATE TABLE t(x)");
  {
    Database::Transaction transaction(database);
    database.run("INSERT INTO t VALUES(1)");
  }
  {
    Database::Transaction transaction(database);
    database.prepare("INSERT INTO t VALUES(?)").bindOptional(1, std::nullopt).run();
    transaction.commit();
  }
  Statement rows = database.prepare("SELECT x FROM t");
  ASSERT_TRUE(rows.step());
  EXPECT_FALSE(rows.optionalInteger(0));
  EXPECT_FALSE(rows.step());
}

TEST(Database, ACopyInMemoryIsOnesOwn) {
  Database database = Database::inMemory("base");
  database.run("CREATE TABLE t(x)");
  Database copy = database.copyInMemory();
  copy.run("INSERT INTO t VALUES(1)");
  EXPECT_FALSE(database.prepare("SELECT x FROM t").step());
  EXPECT_EQ(copy.path(), "base");
}

}  // namespace
}  // namespace vantage
