#include "session/session.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "acquisition/apply_command.h"
#include "base/errors.h"
#include "core/io/expect_error.h"
#include "report/report.h"
#include "session/database.h"
#include "session/session_blobs.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::createSmallSession;
using testing::expectError;
using testing::runSmallSession;
using testing::TemporaryFolder;

AcquisitionSettings twoViews() {
  AcquisitionSettings settings;
  settings.simulation.object = "small";
  settings.maxViews = 2;
  settings.planner.tolerance = 0.3;
  return settings;
}

class SessionTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("test.vantage"); }
  [[nodiscard]] Session reopened() const { return Session::open(path(), SessionAccess::Read); }

  AcquisitionState saveTwoViews() {
    Session session = createSmallSession(path(), twoViews());
    return runSmallSession(session);
  }

  TemporaryFolder folder_;
};

TEST_F(SessionTest, BringsBackWhatWasSavedBitByBit) {
  const AcquisitionState saved = saveTwoViews();
  const Session session = reopened();
  const auto loaded = session.state();
  EXPECT_EQ(loaded->settings.simulation.object, "small");
  EXPECT_EQ(loaded->settings.planner.tolerance, 0.3);
  ASSERT_EQ(countScans(*loaded, ScanStatus::In), 2U);
  EXPECT_EQ(loaded->scans[1].view.T_object_scanner.matrix(), saved.scans[1].view.T_object_scanner.matrix());
  EXPECT_EQ(rangeBlob(loaded->scans[1].view.image->range), rangeBlob(saved.scans[1].view.image->range));
  EXPECT_EQ(modelBlob(*loaded->model), modelBlob(*saved.model));
  EXPECT_EQ(planBlob(*loaded->plan), planBlob(*saved.plan));
  EXPECT_EQ(makeReport(*loaded, "test")["views"], makeReport(saved, "test")["views"]);
  EXPECT_EQ(stateHash(*loaded), stateHash(saved));
  EXPECT_EQ(session.history().current().hash, stateHash(saved));
  EXPECT_TRUE(session.losses().empty());
}

TEST_F(SessionTest, BringsBackEveryStateOfItsHistory) {
  static_cast<void>(saveTwoViews());
  const Session session = reopened();
  ASSERT_EQ(session.history().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(countScans(*session.state(i), ScanStatus::In), i);
    EXPECT_EQ(stateHash(*session.state(i)), session.history().entry(i).hash) << i;
  }
  EXPECT_EQ(session.model(0), nullptr);
  EXPECT_EQ(modelBlob(*session.model(1)), modelBlob(*session.state(1)->model));
  EXPECT_EQ(session.plan(2)->scores.size(), 24U);
}

TEST_F(SessionTest, ReplaysToTheSameBytes) {
  static_cast<void>(saveTwoViews());
  const Session session = reopened();
  const ScannerImages images = computeScannerImages(*session.profile());
  const CommandInput input{[&](std::int64_t number) { return session.scan(number); }, &images};
  AcquisitionState state;
  state.profile = session.profile();
  for (std::size_t i = 0; i < session.history().size(); ++i) {
    state = applyCommand(state, session.history().entry(i).command, input, {});
    EXPECT_EQ(stateHash(state), session.history().entry(i).hash) << kindOf(session.history().entry(i).command);
  }
}

TEST_F(SessionTest, ReadsNothingThatNobodyHolds) {
  static_cast<void>(saveTwoViews());
  const Session session = reopened();
  const std::weak_ptr<const RangeImage> scan = session.scan(0);
  EXPECT_TRUE(scan.expired());
  const auto early = session.state(1);
  const auto late = session.state(2);
  EXPECT_EQ(early->scans[0].view.image, late->scans[0].view.image);
  EXPECT_EQ(early->scans[0].view.mesh, late->scans[0].view.mesh);
}

TEST_F(SessionTest, BringsBackADoubtAndThatLaterScansLiftedIt) {
  AcquisitionSettings settings;
  settings.maxViews = 20;
  // Every view is sent where it shows the most, whether or not it overlaps.
  settings.planner.leastOverlap = 1e9;
  settings.planner.maxRelaxations = 0;
  settings.planner.forecast = false;
  {
    Session session = createSmallSession(path(), settings);
    Acquisition acquisition(session, testing::smallTools(session.profile(), settings));
    acquisition.runUntilTheEnd();
    for (const int between : {2, 3, 4}) {
      acquisition.carryOut(ChoosePosition{between});
      acquisition.scanNext();
    }
  }
  const Session session = reopened();
  EXPECT_TRUE(session.losses().empty());
  int doubts = 0;
  int lifted = 0;
  for (std::size_t i = 0; i < session.history().size(); ++i) {
    const auto state = session.state(i);
    EXPECT_EQ(stateHash(*state), session.history().entry(i).hash) << i;
    for (const KeptScan& scan : state->scans) {
      const VerdictReason reason = scan.record.registration.finding.reason;
      doubts += reason == VerdictReason::TableAlone ? 1 : 0;
      lifted += reason == VerdictReason::HeldByAll ? 1 : 0;
    }
  }
  EXPECT_GT(doubts, 0);
  EXPECT_GT(lifted, 0);
}

TEST_F(SessionTest, UndoAndRedoSurviveReopening) {
  static_cast<void>(saveTwoViews());
  std::uint64_t before = 0;
  {
    Session session = Session::open(path(), SessionAccess::Write);
    Acquisition(session).undo();
    before = stateHash(*session.state());
  }
  Session session = Session::open(path(), SessionAccess::Write);
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 1U);
  EXPECT_EQ(stateHash(*session.state()), before);
  Acquisition(session).redo();
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 2U);
  EXPECT_EQ(session.scanCount(), 2);
}

TEST_F(SessionTest, LeavesViewsOutAndTakesThemBack) {
  static_cast<void>(saveTwoViews());
  Session session = Session::open(path(), SessionAccess::Write);
  Acquisition acquisition(session, {{}, testing::smallTools(session.profile()).images});
  const auto whole = session.state();
  acquisition.carryOut(LeaveOutView{0});
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 1U);
  EXPECT_EQ(scansOf(*session.state(), ScanStatus::In)[0]->number, 1);
  EXPECT_EQ(countScans(*session.state(), ScanStatus::LeftOut), 1U);
  EXPECT_EQ(session.state()->termination, Termination::Running);
  EXPECT_THROW(acquisition.carryOut(LeaveOutView{1}), InvalidInput);
  EXPECT_THROW(acquisition.carryOut(LeaveOutView{7}), InvalidInput);
  acquisition.carryOut(TakeBackView{0});
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 2U);
  EXPECT_EQ(session.state()->scans[0].number, 0);
  EXPECT_EQ(session.state()->scans[0].view.T_object_scanner.matrix(), whole->scans[0].view.T_object_scanner.matrix());
  const std::uint64_t hash = stateHash(*session.state());
  EXPECT_EQ(stateHash(*reopened().state()), hash);
}

TEST_F(SessionTest, AChosenPositionIsScannedNext) {
  AcquisitionSettings settings = twoViews();
  settings.maxViews = 1;
  Session session = createSmallSession(path(), settings);
  static_cast<void>(runSmallSession(session));
  EXPECT_EQ(session.state()->termination, Termination::MaxViews);
  Acquisition(session).carryOut(ChoosePosition{3});
  EXPECT_EQ(session.state()->termination, Termination::Running);
  const AcquisitionState end = runSmallSession(session);
  ASSERT_EQ(end.scans.size(), 2U);
  EXPECT_EQ(end.scans[1].station().position, 3);
  ASSERT_TRUE(end.scans[1].record.predicted);
  EXPECT_FALSE(end.chosenPosition);
  EXPECT_THROW(static_cast<void>(applyCommand(end, ChoosePosition{24}, {}, {})), InvalidInput);
}

TEST_F(SessionTest, HasTheModelOfEveryStepInItsFileWhenItHasSettled) {
  Session session = createSmallSession(path(), twoViews());
  std::size_t steps = 0;
  static_cast<void>(
      runSmallSession(session, [&](const Command&, const AcquisitionState&, const AcquisitionState& state) {
        session.settle();
        Database database(path(), Database::Mode::Read);
        Statement row = database.prepare("SELECT data FROM model WHERE step = (SELECT max(model) FROM step)");
        ASSERT_TRUE(row.step());
        EXPECT_EQ(row.blob(0), modelBlob(*state.model));
        ++steps;
      }));
  EXPECT_GE(steps, 2U);
}

TEST_F(SessionTest, AScanThatWasNotYetAddedIsUsedBeforeAnotherIsTaken) {
  const AcquisitionState whole = saveTwoViews();
  Session session = createSmallSession(folder_.file("again.vantage"), twoViews());
  const Rig rig = testing::simulation(testing::smallObject(), session.profile());
  EXPECT_EQ(session.keepScan(scanFrom(rig, 0, Progress())).number, 0);
  ASSERT_TRUE(session.unusedScan());
  static_cast<void>(runSmallSession(session));
  EXPECT_EQ(session.scanCount(), 2);
  EXPECT_FALSE(session.unusedScan());
  EXPECT_EQ(modelBlob(*session.state()->model), modelBlob(*whole.model));
}

TEST_F(SessionTest, AScanOfAPositionThatDoesNotExistIsRefused) {
  Session session = createSmallSession(path(), twoViews());
  const Rig rig = testing::simulation(testing::smallObject(), session.profile());
  RangeImage image = scanFrom(rig, 0, Progress());
  image.station.position = 24;
  expectError<InvalidInput>([&] { session.keepScan(image); }, {"test.vantage", "position 24"});
  EXPECT_EQ(session.scanCount(), 0);
}

// Earlier sessions have pages of another size.
TEST_F(SessionTest, IsCopiedWithPagesOfAnySize) {
  const AcquisitionState saved = saveTwoViews();
  for (const char* size : {"4096", "65536"}) {
    {
      Database database(path(), Database::Mode::Write);
      database.run("PRAGMA journal_mode=DELETE");
      database.run(std::string("PRAGMA page_size=") + size);
      database.run("VACUUM");
    }
    Session session = Session::open(path(), SessionAccess::Write);
    session.setNote("page", size);
    const std::string copy = folder_.file(std::string("copy-") + size + ".vantage");
    session.copyTo(copy);
    const Session read = Session::open(copy, SessionAccess::Read);
    EXPECT_EQ(stateHash(*read.state()), stateHash(saved));
    EXPECT_EQ(read.note("page"), size);
    Database pages(copy, Database::Mode::Read);
    Statement row = pages.prepare("PRAGMA page_size");
    ASSERT_TRUE(row.step());
    EXPECT_EQ(row.text(0), size);
    EXPECT_EQ(stateHash(*Session::open(copy, SessionAccess::Write).state()), stateHash(saved));
  }
}

TEST_F(SessionTest, KeepsTheRaysOfRecordedScansOnce) {
  const auto profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), profile);
  Session session = Session::create(path(), {std::nullopt, {}, nullptr});
  RangeImage image = scanFrom(rig, 3, Progress());
  image.station.position.reset();
  static_cast<void>(session.keepScan(image));
  static_cast<void>(session.keepScan(image));
  const Session read = reopened();
  EXPECT_EQ(raysBlob(*read.scan(0)->rays), raysBlob(*profile->rays));
  const auto first = read.scan(0);
  EXPECT_EQ(first->rays, read.scan(1)->rays);
}

TEST_F(SessionTest, KeepsRemarks) {
  {
    Session session = createSmallSession(path(), twoViews());
    session.setNote("page", "acquire");
  }
  EXPECT_EQ(reopened().note("page"), "acquire");
  EXPECT_EQ(reopened().note("other"), "");
}

TEST_F(SessionTest, ASecondWriterIsToldWhoHoldsItAndReadersAreNotHindered) {
  Session session = createSmallSession(path(), twoViews());
  expectError<IoError>([&] { static_cast<void>(Session::open(path(), SessionAccess::Write)); },
                       {"test.vantage", "test_session", "process " + std::to_string(getpid())});
  expectError<IoError>([&] { static_cast<void>(createSmallSession(path(), twoViews())); }, {"test_session"});
  const Session reader = reopened();
  static_cast<void>(runSmallSession(session));
  EXPECT_EQ(reader.history().size(), 1U);
  EXPECT_EQ(reader.scanCount(), 0);
  EXPECT_EQ(reopened().history().size(), 3U);
}

TEST_F(SessionTest, RefusesWhatIsNoSession) {
  expectError<IoError>([&] { static_cast<void>(reopened()); }, {"no such file"});
  std::ofstream(path()) << "not a database at all, but long enough to be looked at";
  EXPECT_THROW(static_cast<void>(reopened()), IoError);
  std::filesystem::remove(path());
  Database(path(), Database::Mode::Create).run("CREATE TABLE other(x)");
  EXPECT_THROW(static_cast<void>(reopened()), InvalidInput);
  EXPECT_THROW(static_cast<void>(Session::open(path(), SessionAccess::Write)), InvalidInput);
}

TEST_F(SessionTest, RefusesASchemaThatDoesMoreThanHoldData) {
  static_cast<void>(saveTwoViews());
  Database(path(), Database::Mode::Write).run("CREATE TRIGGER t AFTER INSERT ON event BEGIN DELETE FROM scan; END");
  EXPECT_THROW(static_cast<void>(reopened()), InvalidInput);
}

TEST_F(SessionTest, RefusesATriggerThatHasTheNameOfATable) {
  static_cast<void>(saveTwoViews());
  {
    Database database(path(), Database::Mode::Write);
    const std::string event =
        "CREATE TABLE event(id INTEGER PRIMARY KEY, what TEXT NOT NULL, step INTEGER NOT NULL, sum INTEGER NOT NULL "
        "DEFAULT 0)";
    database.run("ALTER TABLE event RENAME TO e0");
    database.run("CREATE TRIGGER event AFTER INSERT ON scan BEGIN DELETE FROM scan WHERE id = 0; END");
    database.run(event);
    database.run("INSERT INTO event SELECT * FROM e0");
    database.run("DROP TABLE e0");
    // Whatever is in the file, it does not run.
    database.run(
        "INSERT INTO scan SELECT 100, stand, position, known_by, angle_sigma, position_sigma, taken_with, rays, "
        "nominal, "
        "range, colours, sum FROM scan WHERE id = 0");
    EXPECT_EQ(database.prepare("SELECT 1 FROM scan WHERE id = 0").step(), true);
  }
  EXPECT_THROW(static_cast<void>(reopened()), InvalidInput);
  EXPECT_THROW(static_cast<void>(Session::open(path(), SessionAccess::Write)), InvalidInput);
}

TEST(SessionBlobs, RefuseEveryTruncation) {
  Model model;
  model.mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  model.mesh.triangles = {{0, 1, 2}};
  model.confidence = {1, 1, 1};
  model.vertexView = model.vertexSample = {0, 0, 0};
  model.triangleView = {0};
  const auto blob = modelBlob(model);
  EXPECT_EQ(modelFromBlob(blob, "model").mesh.triangles, model.mesh.triangles);
  for (std::size_t size = 0; size < blob.size(); ++size)
    EXPECT_THROW(static_cast<void>(modelFromBlob(std::span(blob).first(size), "model")), InvalidInput) << size;
}

}  // namespace
}  // namespace vantage
