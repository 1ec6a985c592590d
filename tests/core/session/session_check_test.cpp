#include "session/session_check.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "base/errors.h"
#include "base/random.h"
#include "earlier_versions.h"
#include "session/session_schema.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

using testing::bytesOf;

struct Tampering {
  const char* table;
  const char* sql;
  bool sealed;  ///< it is noticed although the sums were put right
};

// Changes that leave every row readable.
constexpr Tampering kTamperings[] = {
    {"view", "UPDATE view SET pose = (SELECT pose FROM view WHERE place = 0 LIMIT 1) WHERE step = 4 AND place = 1",
     true},
    {"view", "UPDATE view SET status = 'left_out' WHERE step = 4 AND place = 1", true},
    {"model", "UPDATE model SET data = (SELECT data FROM model WHERE step = 2) WHERE step = 4", true},
    {"step", "UPDATE step SET chosen = 3 WHERE id = 4", true},
    {"step", "UPDATE step SET settings = replace(settings, '\"max_views\":3', '\"max_views\":9')", true},
    {"step", "UPDATE step SET termination = 'finished' WHERE id = 4", true},
    {"record", "UPDATE record SET data = replace(data, '\"verdict\":\"good\"', '\"verdict\":\"doubtful\"')", true},
    {"plan", "UPDATE plan SET summary = replace(summary, '\"relaxations\":0', '\"relaxations\":2')", true},
    {"scan", "UPDATE scan SET range = (SELECT range FROM scan WHERE id = 0) WHERE id = 1", true},
    {"scan", "UPDATE scan SET position = 5 WHERE id = 1", true},
    {"scan", "DELETE FROM scan WHERE id = 1", true},
    {"view", "DELETE FROM view WHERE step = 4 AND place = 1", true},
    {"object", "UPDATE object SET hash = '0123456789abcdef'", true},
    {"file", "DELETE FROM file", true},
    {"meta", "UPDATE meta SET value = '3' WHERE key = 'cursor'", false},
    {"event", "UPDATE event SET what = 'undo' WHERE id = 1", false}};

class Tamperings : public ::testing::Test {
 protected:
  void SetUp() override {
    AcquisitionSettings settings;
    settings.maxViews = 3;
    Session session = testing::createSmallSession(path(), settings);
    saved_ = testing::runSmallSession(session);
  }
  [[nodiscard]] std::string path() const { return folder_.file("test.vantage"); }

  // What is found in the session once it was changed; a refusal counts as found.
  [[nodiscard]] bool isNamed(const std::function<void(Database&)>& change) const {
    {
      Database database(path(), Database::Mode::Write);
      change(database);
    }
    try {
      const Session session = Session::open(path(), SessionAccess::Read);
      session.check();
      return !session.losses().empty();
    } catch (const Error&) {
      return true;
    }
  }

  testing::TemporaryFolder folder_;
  AcquisitionState saved_;
};

TEST_F(Tamperings, ASessionThatNobodyTouchedIsAsItWasWritten) {
  EXPECT_FALSE(isNamed([](Database&) {}));
}

TEST_F(Tamperings, ARowThatIsNotAsItWasWrittenIsNamedByTableAndKey) {
  SessionStore store(Database(path(), Database::Mode::Write));
  EXPECT_EQ(checkRows(store), std::vector<Loss>());
  store.database().run("UPDATE plan SET summary = summary || ' ' WHERE step = 3");
  const std::vector<Loss> losses = checkRows(store);
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_EQ(losses[0].kind, LossKind::RowDamaged);
  EXPECT_EQ(losses[0].name, "plan");
  EXPECT_EQ(losses[0].number, 3);
}

TEST_F(Tamperings, AreNamedWhateverRowTheyChange) {
  const std::string good = bytesOf(path());
  for (const Tampering& tampering : kTamperings) {
    static_cast<void>(folder_.write("test.vantage", good));
    EXPECT_TRUE(isNamed([&](Database& database) { database.run(tampering.sql); })) << tampering.sql;
  }
}

TEST_F(Tamperings, OfAStateAreNamedAlsoWhereTheSumsWerePutRight) {
  const std::string good = bytesOf(path());
  for (const Tampering& tampering : kTamperings) {
    if (!tampering.sealed) continue;
    static_cast<void>(folder_.write("test.vantage", good));
    EXPECT_TRUE(isNamed([&](Database& database) {
      database.run(tampering.sql);
      addSums(database, tampering.table);
    })) << tampering.sql;
  }
}

TEST_F(Tamperings, AStepThatWasNotAsItWasWrittenIsCarriedOutAgain) {
  {
    Database database(path(), Database::Mode::Write);
    database.run(kTamperings[0].sql);
    addSums(database, "view");
  }
  const Session session = Session::open(path(), SessionAccess::Read);
  EXPECT_EQ(stateHash(*session.state()), stateHash(saved_));
  EXPECT_EQ(session.losses(), (std::vector<Loss>{{LossKind::StateMadeAgain, 4, {}, {}}}));
}

TEST_F(Tamperings, AStepThatCannotBeCarriedOutAgainIsNamed) {
  {
    Database database(path(), Database::Mode::Write);
    database.run("UPDATE step SET hash = '0123456789abcdef' WHERE id = 4");
    addSums(database, "step");
  }
  const Session session = Session::open(path(), SessionAccess::Write);
  EXPECT_EQ(session.losses(), (std::vector<Loss>{{LossKind::StateUntrue, 4, {}, {}}}));
}

// Every bit is named, or nothing in the session depends on it.
TEST_F(Tamperings, SingleBitFlipsChangeNothingUnnoticed) {
  const std::string good = bytesOf(path());
  Random random(11);
  int named = 0;
  constexpr int kTries = 120;
  for (int i = 0; i < kTries; ++i) {
    std::string bad = good;
    const std::size_t at = random.below(good.size());
    bad[at] = static_cast<char>(static_cast<unsigned char>(bad[at]) ^ (1U << random.below(8)));
    std::ofstream(path(), std::ios::binary) << bad;
    try {
      const Session session = Session::open(path(), SessionAccess::Read);
      session.check();
      if (!session.losses().empty()) {
        ++named;
        continue;
      }
      EXPECT_EQ(stateHash(*session.state()), stateHash(saved_)) << "byte " << at;
      EXPECT_EQ(session.history().size(), 4U) << "byte " << at;
    } catch (const Error&) {
      ++named;
    }
  }
  EXPECT_GT(named, kTries / 2);
}

TEST_F(Tamperings, AScanThatIsSaidToStandAnywhereIsNamed) {
  const std::string good = bytesOf(path());
  for (const char* sigmas : {"angle_sigma = 1e15, position_sigma = 1", "angle_sigma = -0.1, position_sigma = 1",
                             "angle_sigma = 0.1, position_sigma = 1e6"}) {
    static_cast<void>(folder_.write("test.vantage", good));
    EXPECT_TRUE(isNamed([&](Database& database) {
      database.run("UPDATE scan SET " + std::string(sigmas) + " WHERE id = 1");
      addSums(database, "scan");
    })) << sigmas;
  }
}

TEST_F(Tamperings, ARangeImageThatClaimsToBeHugeIsRefusedWithoutUnpackingIt) {
  // A zstd frame of one block of zeros that says it holds 1 GiB.
  EXPECT_TRUE(isNamed([](Database& database) {
    database.run("UPDATE scan SET range = x'28b52ffda0000000405400000004000000' WHERE id = 0");
    addSums(database, "scan");
  }));
}

}  // namespace
}  // namespace vantage
