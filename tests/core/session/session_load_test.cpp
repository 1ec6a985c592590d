#include <gtest/gtest.h>
#include <malloc.h>

#include "earlier_versions.h"
#include "large_session.h"
#include "session/session_schema.h"
#include "session/session_store.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// Bytes that the program has asked for and not given back.
std::size_t bytesInUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(SessionLoad, OfManyViewsOnlyWhatIsShownIsInMemory) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("large.vantage");
  testing::writeLargeSession(path, 60);

  const std::size_t before = bytesInUse();
  const Session session = Session::open(path, SessionAccess::Read);
  ASSERT_EQ(session.history().size(), 61U);
  EXPECT_EQ(countScans(*session.history().current().outline, ScanStatus::In), 60U);
  const std::size_t opened = bytesInUse() - before;
  const auto shown = session.scan(30);
  const std::size_t one = bytesInUse() - before - opened;
  // 60 scans of 67,600 samples are 16 MB before anything is made of them; one is 0.27 MB, and 3.3 MB the rays of all.
  EXPECT_LT(opened, 12U << 20);
  EXPECT_LT(one, 5U << 20);
  const std::size_t two = bytesInUse();
  const auto other = session.scan(31);
  EXPECT_LT(bytesInUse() - two, 1U << 20);
}

// A file from anywhere: as many steps again and again, each as it was written.
void addSteps(const std::string& path, std::int64_t count) {
  SessionStore store(Database(path, Database::Mode::Write));
  Database& database = store.database();
  const std::int64_t last = store.nextStep() - 1;
  database.run(
      "INSERT INTO step WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
      std::to_string(count) +
      ") SELECT s.id + i, s.id + i - 1, 'choose_position', '{\"position\":1}', s.settings, s.mode, s.stands, 1, "
      "s.termination, 0, 0, 0, '', 0 FROM n, step s WHERE s.id = " +
      std::to_string(last));
  addSums(database, "step");
  store.setMeta("tip", std::to_string(last + count));
  store.setMeta("cursor", std::to_string(last + count));
}

TEST(SessionLoad, OfVeryManyStepsTheLastAreRead) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("many.vantage");
  static_cast<void>(testing::createSmallSession(path, {}));
  addSteps(path, kMostSteps + 20);
  const std::string bytes = testing::bytesOf(path);

  const std::vector<Loss> unread{{LossKind::StepsUnread, 22, {}, {}}};
  {
    const Session session = Session::open(path, SessionAccess::Read);
    session.check();
    EXPECT_EQ(session.losses(), unread);
    EXPECT_EQ(session.history().size(), static_cast<std::size_t>(kMostSteps));
    EXPECT_EQ(session.history().current().step, kMostSteps + 21);
  }
  EXPECT_EQ(testing::bytesOf(path), bytes);
  EXPECT_EQ(Session::open(path, SessionAccess::Write).losses(), unread);  // and no copy was made
}

TEST(SessionLoad, OfVeryManyDamagedStepsSomeAreNamedAndTheOthersCounted) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("many.vantage");
  static_cast<void>(testing::createSmallSession(path, {}));
  addSteps(path, 500);
  Database(path, Database::Mode::Write).run("UPDATE step SET sum = 1");
  const std::vector<Loss> losses = Session::open(path, SessionAccess::Read).losses();
  EXPECT_EQ(losses.size(), static_cast<std::size_t>(kMostNamed) + 1);
  EXPECT_EQ(losses.back(), (Loss{LossKind::MoreDamaged, 501 - kMostNamed, "step", {}}));
}

}  // namespace
}  // namespace vantage
