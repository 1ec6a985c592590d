#include "session/session_migration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "base/errors.h"
#include "earlier_versions.h"
#include "session/session_blobs.h"
#include "session/session_schema.h"
#include "session/state_hash.h"

namespace vantage {
namespace {

using testing::blobOf;
using testing::bytesOf;
using testing::earlierSession;
using testing::earlierSessions;
using testing::EarlierVersions;
using testing::textsOf;

// Whether a text in JSON has a space in it: then it is a sentence.
bool hasSentence(const nlohmann::json& json) {
  if (json.is_string()) return json.get<std::string>().find(' ') != std::string::npos;
  return json.is_structured() && std::any_of(json.begin(), json.end(), hasSentence);
}

TEST_F(EarlierVersions, AreReadWithoutLossesAndStayAsTheyAre) {
  for (const std::string& name : earlierSessions()) {
    const std::string path = copyOf(name);
    const std::string before = bytesOf(path);
    const Session session = Session::open(path, SessionAccess::Read);
    session.check();
    EXPECT_TRUE(session.losses().empty()) << name;
    EXPECT_EQ(bytesOf(path), before) << name;
  }
}

TEST_F(EarlierVersions, AreBroughtUpToDateOnTheDiskAsInMemory) {
  for (const std::string& name : earlierSessions()) {
    const std::string path = copyOf(name);
    const Session read = Session::open(earlierSession(name), SessionAccess::Read);
    Session written = Session::open(path, SessionAccess::Write);
    EXPECT_TRUE(written.losses().empty()) << name;
    ASSERT_EQ(written.history().size(), read.history().size()) << name;
    EXPECT_EQ(written.history().cursor(), read.history().cursor()) << name;
    for (std::size_t i = 0; i < read.history().size(); ++i)
      EXPECT_EQ(stateHash(*written.state(i)), stateHash(*read.state(i))) << name << " " << i;
    const Session again = Session::open(path, SessionAccess::Read);
    EXPECT_EQ(stateHash(*again.state()), stateHash(*read.state())) << name;
    Database database(path, Database::Mode::Read);
    EXPECT_EQ(checkSessionTables(database), kSessionSchema) << name;
    EXPECT_TRUE(database.sound()) << name;
  }
}

// States were hashed in another way before version 3.
TEST_F(EarlierVersions, HashesOfTheirStepsAreKnownFromVersion3On) {
  for (const std::string& name : earlierSessions()) {
    const std::string path = copyOf(name);
    {
      Session session = Session::open(path, SessionAccess::Write);
      Acquisition(session).carryOut(ChangeSettings{session.state()->settings});
      EXPECT_EQ(session.history().current().hash, stateHash(*session.state())) << name;
    }
    const Session read = Session::open(path, SessionAccess::Read);
    for (std::size_t i = 0; i + 1 < read.history().size(); ++i)
      EXPECT_EQ(read.history().entry(i).hash.has_value(), name.starts_with("schema_3") || name.starts_with("schema_4"))
          << name;
    EXPECT_EQ(read.history().current().hash, stateHash(*read.state())) << name;
  }
}

// In the files the rows of every version are called the same.
TEST_F(EarlierVersions, KeepEveryScanAndEveryModel) {
  for (const std::string& name : earlierSessions()) {
    const std::string path = copyOf(name);
    Database earlier(earlierSession(name), Database::Mode::Read);
    static_cast<void>(Session::open(path, SessionAccess::Write));
    Database now(path, Database::Mode::Read);
    for (const char* query : {"SELECT hex(range) || hex(nominal) || ifnull(rays, '') FROM scan ORDER BY id",
                              "SELECT hex(data) FROM model ORDER BY rowid", "SELECT hex(data) FROM rays ORDER BY id",
                              "SELECT content FROM file ORDER BY name"})
      EXPECT_EQ(textsOf(now, query), textsOf(earlier, query)) << name << ": " << query;
  }
}

TEST_F(EarlierVersions, CanBeUndoneAndRedoneFromEndToEnd) {
  for (const std::string& name : earlierSessions()) {
    Session session = Session::open(copyOf(name), SessionAccess::Write);
    Acquisition acquisition(session);
    const std::uint64_t hash = stateHash(*session.state());
    const std::size_t cursor = session.history().cursor();
    while (!acquisition.mayUndo()) acquisition.undo();
    EXPECT_EQ(session.history().cursor(), 0U);
    EXPECT_TRUE(session.state()->scans.empty());
    while (!acquisition.mayRedo()) acquisition.redo();
    EXPECT_EQ(session.history().cursor() + 1, session.history().size());
    while (session.history().cursor() > cursor) acquisition.undo();
    EXPECT_EQ(stateHash(*session.state()), hash) << name;
    EXPECT_TRUE(session.losses().empty()) << name;
  }
}

TEST_F(EarlierVersions, HoldNoSentencesAnyMore) {
  for (const std::string& name : earlierSessions()) {
    const std::string path = copyOf(name);
    static_cast<void>(Session::open(path, SessionAccess::Write));
    Database database(path, Database::Mode::Read);
    for (const char* query : {"SELECT data FROM record", "SELECT summary FROM plan", "SELECT command FROM step"})
      for (const std::string& text : textsOf(database, query))
        EXPECT_FALSE(hasSentence(nlohmann::json::parse(text))) << name << ": " << text;
  }
}

TEST_F(EarlierVersions, ReasonsAreCodesWithWhatWasMeasured) {
  const Session ended = Session::open(earlierSession("schema_2_ended"), SessionAccess::Read);
  const auto state = ended.state(5);
  ASSERT_EQ(state->scans.size(), 3U);
  EXPECT_EQ(state->scans[0].record.registration.finding.reason, VerdictReason::FirstView);
  EXPECT_EQ(state->scans[1].record.registration.finding.reason, VerdictReason::FewPairs);
  EXPECT_EQ(state->scans[1].record.registration.finding.value, 208.0);
  const Finding& held = state->scans[2].record.registration.finding;
  EXPECT_EQ(held.reason, VerdictReason::HeldByMechanics);
  ASSERT_EQ(held.motions.size(), 1U);
  EXPECT_EQ(held.motions[0].kind, WeakMotion::Kind::Turn);
  EXPECT_TRUE(held.motions[0].axis.isApprox(Vec3(0.6, 0.8, -0.2)));
  const Session first = Session::open(earlierSession("schema_1"), SessionAccess::Read);
  EXPECT_EQ(first.state()->scans[1].record.registration.finding.reason, VerdictReason::EarlierVersion);
  EXPECT_EQ(first.state()->scans[1].record.samples, 398U);
}

TEST_F(EarlierVersions, WhatTheOperatorEndedIsNotFinished) {
  const Session session = Session::open(earlierSession("schema_2_ended"), SessionAccess::Read);
  EXPECT_EQ(session.state()->termination, Termination::EndedByOperator);
  EXPECT_EQ(std::get<Finish>(session.history().current().command).termination, Termination::EndedByOperator);
  EXPECT_EQ(session.state(4)->termination, Termination::Running);
  EXPECT_EQ(session.state(5)->termination, Termination::MaxViews);
}

TEST_F(EarlierVersions, WhatWasImportedIsNotFinished) {
  const Session session = Session::open(earlierSession("schema_2_imported"), SessionAccess::Read);
  EXPECT_EQ(session.state()->termination, Termination::Imported);
  EXPECT_EQ(session.state(0)->termination, Termination::Running);
  ASSERT_EQ(countScans(*session.state(), ScanStatus::In), 3U);
  for (const KeptScan& scan : session.state()->scans) {
    EXPECT_FALSE(scan.station().position);
    EXPECT_EQ(scan.view.image->poseKnownBy, PoseSource::Reported);
  }
  EXPECT_FALSE(session.profile());
}

TEST_F(EarlierVersions, ScansOfAllKindsAreOneListInTheirOrder) {
  const Session session = Session::open(earlierSession("schema_2_steered"), SessionAccess::Read);
  const AcquisitionState& state = *session.state();
  ASSERT_EQ(state.scans.size(), 3U);
  const std::tuple<ScanStatus, int> expected[] = {
      {ScanStatus::LeftOut, 0}, {ScanStatus::Rejected, 12}, {ScanStatus::In, 23}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(state.scans[i].number, static_cast<std::int64_t>(i));
    EXPECT_EQ(state.scans[i].status, std::get<0>(expected[i]));
    EXPECT_EQ(state.scans[i].station().position, std::get<1>(expected[i]));
    EXPECT_EQ(state.scans[i].station().stand, 0);
  }
  EXPECT_EQ(state.chosenPosition, 5);
  EXPECT_EQ(nextPosition(state), 5);
  EXPECT_EQ(state.settings.maxViews, 8);
  EXPECT_EQ(state.settings.simulation.object, "small.ply");
  EXPECT_EQ(state.stands.size(), 1U);
  EXPECT_FALSE(session.state(7)->chosenPosition);
  EXPECT_FALSE(std::get<ChoosePosition>(session.history().entry(7).command).position);
}

// What a view was planned from when it was added stays with it; what holds belongs to the state.
TEST_F(EarlierVersions, ThePlanBelongsToTheState) {
  const std::string path = earlierSession("schema_2_steered");
  const Session session = Session::open(path, SessionAccess::Read);
  EXPECT_EQ(planBlob(*session.state(5)->plan), blobOf(path, "SELECT data FROM plan WHERE step = 6"));
  EXPECT_EQ(planBlob(*session.state(5)->scans[2].record.planAfter),
            blobOf(path, "SELECT data FROM plan WHERE step = 5"));
  EXPECT_EQ(planBlob(*session.state(9)->plan), blobOf(path, "SELECT data FROM plan WHERE step = 10"));
  EXPECT_FALSE(session.state(0)->plan);
}

TEST_F(EarlierVersions, AMigrationThatIsInterruptedLeavesTheFileAsItWas) {
  for (const std::string& name : earlierSessions()) {
    const std::string path = copyOf(name);
    {
      Database database(path, Database::Mode::Write);
      Statement pages = database.prepare("PRAGMA page_count");
      ASSERT_TRUE(pages.step());
      // There is room for a few pages only: the disk runs full in the midst of it.
      database.run("PRAGMA max_page_count = " + std::to_string(pages.integer(0) + 2));
      EXPECT_THROW(migrateSession(database), IoError) << name;
      EXPECT_NE(checkSessionTables(database), kSessionSchema) << name;
    }
    const Session session = Session::open(path, SessionAccess::Write);
    EXPECT_TRUE(session.losses().empty()) << name;
    EXPECT_EQ(stateHash(*session.state()),
              stateHash(*Session::open(earlierSession(name), SessionAccess::Read).state()));
  }
}

}  // namespace
}  // namespace vantage
