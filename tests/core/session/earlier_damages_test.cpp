#include "session/earlier_damages.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "earlier_versions.h"

namespace vantage {
namespace {

using testing::EarlierVersions;

TEST_F(EarlierVersions, OnlyTheStepsThatDependOnAChangeAreNamed) {
  Database database = Database(testing::earlierSession("schema_2_ended"), Database::Mode::Read).copyInMemory();
  EXPECT_EQ(earlierDamages(database, 2), std::vector<Loss>());
  database.run("UPDATE step SET chosen = 4 WHERE id = 3");
  EXPECT_EQ(earlierDamages(database, 2), (std::vector<Loss>{{LossKind::StateUntrue, 3, {}, {}}}));
  EXPECT_EQ(earlierDamages(database, 1), std::vector<Loss>());
}

TEST_F(EarlierVersions, StepsThatAreNotAsTheyWereWrittenAreNamedAndRemembered) {
  for (const char* sql : {"UPDATE view SET pose = (SELECT nominal FROM scan WHERE id = 0) WHERE step = 3 AND scan = 1",
                          "UPDATE model SET data = (SELECT data FROM model WHERE step = 2)",
                          "UPDATE scan SET position = 3 WHERE id = 0"}) {
    const std::string path = copyOf("schema_2_ended");
    {
      Database database(path, Database::Mode::Write);
      database.run(sql);
      database.run("PRAGMA journal_mode=DELETE");
    }
    const std::vector<Loss> read = Session::open(path, SessionAccess::Read).losses();
    EXPECT_FALSE(read.empty()) << sql;
    for (const Loss& loss : read) EXPECT_EQ(loss.kind, LossKind::StateUntrue) << sql;
    const std::vector<Loss> written = Session::open(path, SessionAccess::Write).losses();
    EXPECT_EQ(written.size(), read.size() + 1) << sql;  // the copy
    EXPECT_TRUE(std::filesystem::exists(path + ".damaged-1")) << sql;
    const std::vector<Loss> again = Session::open(path, SessionAccess::Write).losses();
    EXPECT_EQ(again, read) << sql;
    EXPECT_FALSE(std::filesystem::exists(path + ".damaged-2")) << sql;
    std::filesystem::remove(path + ".damaged-1");
  }
}

TEST_F(EarlierVersions, ThePathOfAnObjectMayBeAnother) {
  const std::string path = copyOf("schema_2_steered");
  Database(path, Database::Mode::Write).run("UPDATE step SET settings = replace(settings, 'small.ply', '')");
  const Session session = Session::open(path, SessionAccess::Read);
  EXPECT_EQ(session.losses(), std::vector<Loss>());
}

}  // namespace
}  // namespace vantage
