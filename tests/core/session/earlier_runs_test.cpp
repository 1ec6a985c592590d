#include <gtest/gtest.h>

#include <optional>

#include "acquisition/apply_command.h"
#include "earlier_versions.h"
#include "positional_space/scanner_images.h"
#include "session/session_blobs.h"

namespace vantage {
namespace {

using testing::earlierSession;
using testing::earlierTools;
using testing::EarlierVersions;
using testing::lastModelOf;
using testing::textsOf;

// Every model of these files was made by the program of its time; the engine still makes them to the same bytes.
TEST_F(EarlierVersions, TheirCommandsStillLeadToTheSameModels) {
  for (const std::string name : {"schema_2_ended", "schema_2_steered", "schema_2_imported"}) {
    const Session session = Session::open(earlierSession(name), SessionAccess::Read);
    std::optional<ScannerImages> images;
    if (session.profile()) images = computeScannerImages(*session.profile());
    const CommandInput input{[&](std::int64_t number) { return session.scan(number); }, images ? &*images : nullptr};
    AcquisitionState state;
    state.profile = session.profile();
    for (std::size_t i = 0; i < session.history().size(); ++i) {
      state = applyCommand(state, session.history().entry(i).command, input, {});
      const auto then = session.state(i);
      ASSERT_EQ(state.scans.size(), then->scans.size()) << name << " " << i;
      EXPECT_EQ(state.termination, then->termination) << name << " " << i;
      EXPECT_EQ(state.chosenPosition, then->chosenPosition) << name << " " << i;
      ASSERT_EQ(state.model == nullptr, then->model == nullptr) << name << " " << i;
      if (state.model) {
        EXPECT_EQ(modelBlob(*state.model), modelBlob(*then->model)) << name << " " << i;
      }
      ASSERT_EQ(state.plan == nullptr, then->plan == nullptr) << name << " " << i;
      if (state.plan) {
        EXPECT_EQ(planBlob(*state.plan), planBlob(*then->plan)) << name << " " << i;
      }
      for (std::size_t k = 0; k < state.scans.size(); ++k) {
        EXPECT_EQ(state.scans[k].status, then->scans[k].status) << name << " " << i;
        EXPECT_EQ(state.scans[k].view.T_object_scanner.matrix(), then->scans[k].view.T_object_scanner.matrix())
            << name << " " << i << " " << k;
      }
    }
  }
}

// Takes out what was undone, with the scan that it had taken.
void cutOffUndone(const std::string& path) {
  Database database(path, Database::Mode::Write);
  const std::string cursor = textsOf(database, "SELECT value FROM meta WHERE key = 'cursor'").at(0);
  for (const char* table : {"view WHERE step", "record WHERE step", "plan WHERE step", "model WHERE step",
                            "event WHERE step", "step WHERE id"})
    database.run(std::string("DELETE FROM ") + table + " > " + cursor);
  database.run("DELETE FROM scan WHERE id NOT IN (SELECT scan FROM view)");
  database.run("UPDATE meta SET value = '" + cursor + "' WHERE key = 'tip'");
}

// The last model of each file is what the program of its time came to from the state that holds: scans, poses and
// zippering of that run, which is taken again here, came from the same engine, scanner and seed, so that the bytes are
// the same.
TEST_F(EarlierVersions, GoOnToWhatTheProgramOfTheirTimeCameTo) {
  for (const std::string name : {"schema_2_taken_over", "schema_2_ended"}) {
    const std::vector<std::byte> expected = lastModelOf(earlierSession(name));
    const std::string path = copyOf(name);
    cutOffUndone(path);
    Session session = Session::open(path, SessionAccess::Write);
    ASSERT_EQ(countScans(*session.state(), ScanStatus::In), 2U) << name;
    Acquisition acquisition(session, earlierTools(session));
    if (session.state()->termination != Termination::Running) acquisition.carryOut(Finish{Termination::Running});
    EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::MaxViews) << name;
    EXPECT_EQ(modelBlob(*session.state()->model), expected) << name;
    EXPECT_EQ(session.scanCount(), 3) << name;
  }
}

TEST_F(EarlierVersions, TheFirstVersionGoesOnAsTheSecondWentOnWithIt) {
  Session session = Session::open(copyOf("schema_1"), SessionAccess::Write);
  Acquisition acquisition(session, earlierTools(session));
  EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::MaxViews);
  EXPECT_EQ(modelBlob(*session.state()->model), lastModelOf(earlierSession("schema_2_taken_over")));
}

TEST_F(EarlierVersions, OneThatIsSteeredGoesOnFromTheChosenPosition) {
  Session session = Session::open(copyOf("schema_2_steered"), SessionAccess::Write);
  Acquisition acquisition(session, earlierTools(session));
  acquisition.scanNext();
  ASSERT_EQ(session.state()->scans.size(), 4U);
  EXPECT_EQ(session.state()->scans[3].station().position, 5);
  EXPECT_FALSE(session.state()->chosenPosition);
  acquisition.carryOut(TakeBackView{0});
  EXPECT_EQ(session.state()->scans[0].status, ScanStatus::In);
}

TEST_F(EarlierVersions, ModelsThatWereLostAreMadeAgain) {
  const std::string path = copyOf("schema_2_ended");
  Database(path, Database::Mode::Write).run("DELETE FROM model");
  const Session session = Session::open(path, SessionAccess::Read);
  EXPECT_EQ(modelBlob(*session.state(5)->model), lastModelOf(earlierSession("schema_2_ended")));
}

}  // namespace
}  // namespace vantage
