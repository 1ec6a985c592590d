#include "session/session_opening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/errors.h"
#include "earlier_versions.h"
#include "session/session_schema.h"

namespace vantage {
namespace {

using testing::bytesOf;
using testing::earlierSession;
using testing::EarlierVersions;

// Of one row of each kind the text is damaged.
TEST_F(EarlierVersions, ADamagedRowIsNamedAndLosesNothingElse) {
  struct Damage {
    const char* sql;
    LossKind kind;
    std::string table;
    std::int64_t number;
  };
  const Damage damages[] = {{"UPDATE record SET data = '{\"scan\": 2' WHERE id = 3", LossKind::RowDamaged, "record", 3},
                            {"UPDATE step SET settings = '{}' WHERE id = 6", LossKind::RowDamaged, "step", 6},
                            {"UPDATE step SET command = 'x' WHERE id = 6", LossKind::RowDamaged, "step", 6},
                            {"UPDATE plan SET summary = '[' WHERE step = 6", LossKind::PlanDamaged, "", 6}};
  for (const Damage& damage : damages) {
    const char* sql = damage.sql;
    for (const SessionAccess access : {SessionAccess::Read, SessionAccess::Write}) {
      const testing::TemporaryFolder folder;
      const std::string path = folder.write("ended.vantage", bytesOf(earlierSession("schema_2_ended")));
      {
        Database database(path, Database::Mode::Write);
        database.run(sql);
        database.run("PRAGMA journal_mode=DELETE");
      }
      const std::string damaged = bytesOf(path);
      const Session session = Session::open(path, access);
      EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 2U) << sql;
      EXPECT_EQ(session.state()->termination, Termination::EndedByOperator) << sql;
      for (std::size_t i = 0; i < session.history().size(); ++i) static_cast<void>(session.state(i));
      const std::vector<Loss> losses = session.losses();
      EXPECT_TRUE(std::any_of(losses.begin(), losses.end(), [&](const Loss& loss) {
        return loss.kind == damage.kind && loss.name == damage.table && loss.number == damage.number &&
               !loss.error.empty();
      })) << sql;
      // A plan is read when it is asked for.
      if (access == SessionAccess::Write && damage.kind != LossKind::PlanDamaged) {
        EXPECT_EQ(bytesOf(path + ".damaged-1"), damaged) << sql;
      }
    }
  }
}

TEST_F(EarlierVersions, ADamagedSessionIsCopiedWhateverItSaysOfEarlierCopies) {
  const std::string path = copyOf("schema_2_ended");
  const std::string other = folder_.write("other.txt", "no session");
  {
    Database database(path, Database::Mode::Write);
    database.run("UPDATE record SET data = '' WHERE id = 3");
    database.run("INSERT OR REPLACE INTO meta VALUES('damaged_copy', '" + other + "'), ('damages', '1')");
    database.run("PRAGMA journal_mode=DELETE");
  }
  const std::string damaged = bytesOf(path);
  { const Session session = Session::open(path, SessionAccess::Write); }
  ASSERT_TRUE(std::filesystem::exists(path + ".damaged-1"));
  EXPECT_EQ(bytesOf(path + ".damaged-1"), damaged);
  // That one is known, and enough.
  { const Session session = Session::open(path, SessionAccess::Write); }
  EXPECT_FALSE(std::filesystem::exists(path + ".damaged-2"));
}

TEST_F(EarlierVersions, DamagedPagesAreRescuedAndBroughtUpToDate) {
  const std::string good = bytesOf(earlierSession("schema_2_ended"));
  constexpr std::size_t kPage = 1024;
  int opened = 0;
  int tried = 0;
  for (std::size_t page = 20; page < good.size() / kPage; page += 9) {
    std::string bad = good;
    std::fill_n(bad.begin() + static_cast<std::ptrdiff_t>(page * kPage), kPage, '\x2a');
    const testing::TemporaryFolder folder;
    const std::string path = folder.write("bad.vantage", bad);
    ++tried;
    try {
      const Session session = Session::open(path, SessionAccess::Write);
      Database database(path, Database::Mode::Read);
      EXPECT_EQ(checkSessionTables(database), kSessionSchema) << page;
      EXPECT_TRUE(database.sound()) << page;
      static_cast<void>(session.state());
      ++opened;
    } catch (const Error&) {
      // Of some pages nothing else can be read without them.
    }
    if (std::filesystem::exists(path + ".damaged-1")) {
      EXPECT_EQ(bytesOf(path + ".damaged-1"), bad) << page;
    }
  }
  EXPECT_GE(opened, tried * 3 / 4);
}

}  // namespace
}  // namespace vantage
