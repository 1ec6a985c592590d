#include "session/earlier_endings.h"

#include <gtest/gtest.h>

#include "session/command_json.h"
#include "session/session_json.h"
#include "session/session_schema.h"

namespace vantage {
namespace {

// The steps of a session that an earlier version ended, in the tables of now.
class EarlierEndings : public ::testing::Test {
 protected:
  EarlierEndings() : database_(Database::inMemory("endings.vantage")) { createSessionTables(database_, 3); }

  // A step after which the acquisition is called finished, with so many views. @return its number
  int addFinished(const std::string& kind, int parent, int views, const std::string& strategy = "ps",
                  std::int64_t plan = 0) {
    AcquisitionSettings settings;
    settings.strategy = parseStrategy(strategy);
    const int step = ++steps_;
    database_.prepare("INSERT INTO step VALUES(?, ?, ?, '{}', ?, 'automatic', '', NULL, 'finished', ?, 0, ?, '')")
        .bind(1, std::int64_t{step})
        .bind(2, std::int64_t{parent})
        .bind(3, std::string_view(kind))
        .bind(4, std::string_view(settingsText(settings)))
        .bind(5, std::int64_t{views})
        .bind(6, plan)
        .run();
    for (int i = 0; i < views; ++i)
      database_
          .prepare("INSERT INTO view(step, place, scan, status, pose, record, plan) VALUES(?, 0, 0, 'in', '', 0, 0)")
          .bind(1, std::int64_t{step})
          .run();
    return step;
  }

  void addPlan(int step, const std::string& summary) {
    database_.prepare("INSERT INTO plan VALUES(?, ?, '')")
        .bind(1, std::int64_t{step})
        .bind(2, std::string_view(summary))
        .run();
  }

  std::string terminationOf(int step) {
    Statement row = database_.prepare("SELECT termination FROM step WHERE id = ?");
    row.bind(1, std::int64_t{step});
    return row.step() ? row.text(0) : std::string();
  }

  Database database_;
  int steps_ = 0;
};

TEST_F(EarlierEndings, APlanThatFoundAPositionWasEndedByTheOperator) {
  addPlan(1, R"({"outcome": "found"})");
  addPlan(2, R"({"outcome": "finished"})");
  const int by = addFinished("finish", 0, 2, "ps", 1);
  const int itself = addFinished("finish", 0, 2, "ps", 2);
  const int added = addFinished("add_scan", 0, 2, "ps", 2);
  renameEarlierEndings(database_);
  EXPECT_EQ(terminationOf(by), "ended_by_operator");
  EXPECT_EQ(terminationOf(itself), "finished");
  EXPECT_EQ(terminationOf(added), "finished");
  Statement row = database_.prepare("SELECT command FROM step WHERE id = 1");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(0), commandText(Finish{Termination::EndedByOperator}));
}

TEST_F(EarlierEndings, ABaselineIsFinishedWhenAllOfItsViewsWereTaken) {
  const int early = addFinished("finish", 0, 2, "uniform:3");
  const int whole = addFinished("finish", 0, 3, "uniform:3");
  const int random = addFinished("finish", 0, 3, "random");
  renameEarlierEndings(database_);
  EXPECT_EQ(terminationOf(early), "ended_by_operator");
  EXPECT_EQ(terminationOf(whole), "finished");
  EXPECT_EQ(terminationOf(random), "ended_by_operator");
}

// An import that was undone has no say in the branch that was scanned instead.
TEST_F(EarlierEndings, AnImportIsOneInItsOwnBranchOnly) {
  addPlan(9, R"({"outcome": "finished"})");
  const int import = addFinished("import_scans", 0, 2);
  const int without = addFinished("leave_out", import, 1);
  const int scanned = addFinished("add_scan", 0, 2, "ps", 9);
  renameEarlierEndings(database_);
  EXPECT_EQ(terminationOf(import), "imported");
  EXPECT_EQ(terminationOf(without), "imported");
  EXPECT_EQ(terminationOf(scanned), "finished");
}

TEST_F(EarlierEndings, AnotherPositionLeavesTheEndAsItWas) {
  const int ended = addFinished("finish", 0, 2);
  const int chosen = addFinished("choose_position", ended, 2);
  renameEarlierEndings(database_);
  EXPECT_EQ(terminationOf(chosen), "ended_by_operator");
}

TEST_F(EarlierEndings, DamagedSettingsLeaveItWhatItWasCalled) {
  const int step = addFinished("finish", 0, 2);
  database_.run("UPDATE step SET settings = '{'");
  renameEarlierEndings(database_);
  EXPECT_EQ(terminationOf(step), "finished");
}

}  // namespace
}  // namespace vantage
