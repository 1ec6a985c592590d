#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <new>

#include "base/errors.h"
#include "base/random.h"
#include "core/io/expect_error.h"
#include "earlier_versions.h"
#include "faulty_storage.h"
#include "session/database.h"
#include "session/session.h"
#include "session/session_blobs.h"
#include "session/state_hash.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

// Every fault ends in a message, a session that is whole, and a way on that leads to what would have been without it.

namespace vantage {
namespace {

using testing::createSmallSession;
using testing::expectError;
using testing::runSmallSession;
using testing::TemporaryFolder;

AcquisitionSettings threeViews() {
  AcquisitionSettings settings;
  settings.maxViews = 3;
  return settings;
}

const AcquisitionState& undisturbed() {
  static const AcquisitionState state = testing::acquireSmallObject(threeViews(), 1);
  return state;
}

class SessionFaults : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("test.vantage"); }

  // What is on the disk is what the program believes, and goes on to the undisturbed end.
  void expectWholeAndGoOn(Session session) {
    const std::uint64_t hash = stateHash(*session.state());
    EXPECT_EQ(stateHash(*Session::open(path(), SessionAccess::Read).state()), hash);
    static_cast<void>(runSmallSession(session));
    EXPECT_EQ(modelBlob(*session.state()->model), modelBlob(*undisturbed().model));
    EXPECT_EQ(session.state()->termination, undisturbed().termination);
  }

  TemporaryFolder folder_;
};

// Before every capture it is asked, by the number of the capture from 1, which sensor is to take it.
class ChosenSensor final : public RangeSensor {
 public:
  using Choose = std::function<RangeSensor&(int capture)>;
  explicit ChosenSensor(Choose choose) : choose_(std::move(choose)) {}

  [[nodiscard]] std::string identity() const override { return "chosen sensor"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] RangeImage capture(const Progress& progress) override { return choose_(++captures_).capture(progress); }

 private:
  Choose choose_;
  int captures_ = 0;
};

// An acquisition whose second scan meets with something.
void acquireMeeting(Session& session, const std::function<void()>& meet) {
  const Rig simulated =
      testing::simulation(session.object(), session.profile(), {}, static_cast<int>(session.scanCount()));
  const auto meeting = [&](int capture) -> RangeSensor& {
    if (capture == 2) meet();
    return *simulated.sensor;
  };
  const Rig rig{std::make_shared<ChosenSensor>(meeting), simulated.positioner};
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*session.profile()));
  Acquisition(session, {rig, images}).runUntilTheEnd();
}

TEST_F(SessionFaults, ADiskThatRunsFullAtAnyWriteLosesNothingThatWasReported) {
  testing::FaultyStorage storage;
  Session session = createSmallSession(path(), threeViews());
  int failures = 0;
  for (int writes = 0; session.state()->termination == Termination::Running; writes += 1 + writes / 3) {
    std::uint64_t reported = stateHash(*session.state());
    storage.fillAfter(writes);
    try {
      static_cast<void>(runSmallSession(session, [&](const Command&, const AcquisitionState&,
                                                     const AcquisitionState& state) { reported = stateHash(state); }));
    } catch (const IoError& e) {
      ++failures;
      EXPECT_NE(std::string(e.what()).find("disk is full"), std::string::npos) << e.what();
    }
    storage.heal();
    EXPECT_EQ(stateHash(*session.state()), reported);
    EXPECT_EQ(stateHash(*Session::open(path(), SessionAccess::Read).state()), reported);
  }
  EXPECT_GT(failures, 8);
  EXPECT_EQ(modelBlob(*session.state()->model), modelBlob(*undisturbed().model));
}

// The first recorded scan brings its rays along: a scan that could not be written must not leave the session believing
// that it has them.
TEST_F(SessionFaults, ARecordedScanThatFoundNoRoomIsKeptWithItsRaysLater) {
  testing::FaultyStorage storage;
  Session session = Session::create(path(), {std::nullopt, {}, nullptr});
  RangeImage image = scanFrom(testing::simulation(testing::smallObject(), testing::smallProfile()), 0, Progress());
  image.station.position.reset();
  storage.fillAfter(0);
  expectError<IoError>([&] { session.keepScan(image); }, {"disk is full"});
  storage.heal();
  EXPECT_EQ(session.scanCount(), 0);
  EXPECT_EQ(session.keepScan(image).number, 0);
  const Session read = Session::open(path(), SessionAccess::Read);
  EXPECT_EQ(raysBlob(*read.scan(0)->rays), raysBlob(*image.rays));
  EXPECT_EQ(rangeBlob(read.scan(0)->range), rangeBlob(image.range));
}

TEST_F(SessionFaults, AScannerThatFailsInTheMiddleOfAScanLeavesTheLastStepWhole) {
  Session session = createSmallSession(path(), threeViews());
  expectError<DeviceError>([&] { acquireMeeting(session, [] { throw DeviceError("laser: no light"); }); },
                           {"no light"});
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 1U);
  expectWholeAndGoOn(std::move(session));
}

TEST_F(SessionFaults, AnInterruptionInTheMiddleOfAStepKeepsItsScan) {
  Session session = createSmallSession(path(), threeViews());
  const Progress outOfMemory(
      [&](double /*fraction*/, std::string_view step) {
        if (step == "integrate" && session.scanCount() == 2) throw std::bad_alloc();
      },
      {}, 1);
  EXPECT_THROW(static_cast<void>(runSmallSession(session, {}, outOfMemory)), std::bad_alloc);
  EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 1U);
  ASSERT_TRUE(session.unusedScan());
  EXPECT_EQ(session.unusedScan()->number, 1);
  expectWholeAndGoOn(std::move(session));
}

TEST_F(SessionFaults, AScanThatCannotBeRegisteredIsKeptAsRejected) {
  Session session = createSmallSession(path(), threeViews());
  const auto table = std::make_shared<SimulatedTable>(session.profile(), SimulationOptions());
  const auto before = [&](Mesh object) {
    auto sensor = std::make_shared<SimulatedSensor>(std::make_shared<const Mesh>(std::move(object)), session.profile(),
                                                    SimulationOptions(), table);
    sensor->open({});
    return sensor;
  };
  const auto right = before(testing::smallObject());
  const auto wrong = before(testing::makeBox({-10, -40, 70}, {40, -20, 90}, 4));
  const auto swapped = [&](int capture) -> RangeSensor& { return capture == 1 ? *right : *wrong; };
  const Rig rig{std::make_shared<ChosenSensor>(swapped), table};
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*session.profile()));
  Acquisition acquisition(session, {rig, images});
  EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::RegistrationFailed);
  const AcquisitionState end = *session.state();
  const auto rejected = scansOf(end, ScanStatus::Rejected);
  EXPECT_EQ(end.termination, Termination::RegistrationFailed);
  EXPECT_EQ(countScans(end, ScanStatus::In), 1U);
  ASSERT_GE(rejected.size(), 1U);
  EXPECT_NE(rejected[0]->record.registration.finding.reason, VerdictReason::NotRegistered);
  const Session read = Session::open(path(), SessionAccess::Read);
  EXPECT_EQ(stateHash(*read.state()), stateHash(end));
  EXPECT_EQ(read.scanCount(), static_cast<std::int64_t>(1 + rejected.size()));
  // The way on: undo the rejected scans, and scan again with the right object in front of the scanner.
  while (countScans(*session.state(), ScanStatus::Rejected) > 0) acquisition.undo();
  EXPECT_EQ(session.state()->termination, Termination::Running);
}

TEST_F(SessionFaults, AFileThatIsRemovedWhileItIsOpenIsWrittenElsewhere) {
  Session session = createSmallSession(path(), threeViews());
  const std::string removed = path();
  expectError<IoError>([&] { acquireMeeting(session, [&] { std::filesystem::remove(removed); }); },
                       {"was removed", "test.vantage.rescued-1"});
  const std::string rescued = path() + ".rescued-1";
  std::filesystem::rename(rescued, path());
  Session found = Session::open(path(), SessionAccess::Read);
  EXPECT_EQ(countScans(*found.state(), ScanStatus::In), 1U);
  EXPECT_EQ(found.scanCount(), 2);
  session = std::move(found);
  expectWholeAndGoOn(Session::open(path(), SessionAccess::Write));
}

TEST_F(SessionFaults, AFolderThatCannotBeWrittenToSaysSoAndIsRead) {
  {
    Session session = createSmallSession(path(), threeViews());
    static_cast<void>(runSmallSession(session));
  }
  const auto folder = std::filesystem::path(path()).parent_path();
  std::filesystem::permissions(folder, std::filesystem::perms(0555));
  const bool root = geteuid() == 0;
  ASSERT_TRUE(!root || seteuid(65534) == 0);
  expectError<IoError>([&] { static_cast<void>(Session::open(path(), SessionAccess::Write)); }, {"cannot be written"});
  expectError<IoError>([&] { static_cast<void>(createSmallSession(folder / "new.vantage", {})); },
                       {"cannot be written"});
  EXPECT_EQ(countScans(*Session::open(path(), SessionAccess::Read).state(), ScanStatus::In), 3U);
  ASSERT_TRUE(!root || seteuid(0) == 0);
  std::filesystem::permissions(folder, std::filesystem::perms(0755));
}

// The last write before the power went is there in part, or as something else. What was reported before it is there.
TEST_F(SessionFaults, AWriteThatWasTornLeavesTheStepBeforeIt) {
  std::vector<std::uint64_t> hashes;
  std::string file;
  std::string log;
  {
    Session session = createSmallSession(path(), threeViews());
    static_cast<void>(runSmallSession(session));
    session.settle();
    for (std::size_t i = 0; i < session.history().size(); ++i) hashes.push_back(*session.history().entry(i).hash);
    file = testing::bytesOf(path());
    log = testing::bytesOf(path() + "-wal");
  }
  ASSERT_FALSE(log.empty());
  Random random(7);
  std::size_t cutShort = 0;
  for (int i = 0; i < 200; ++i) {
    const TemporaryFolder folder;
    const std::string copy = folder.write("torn.vantage", file);
    std::string torn = log.substr(0, 1 + random.below(log.size()));
    // Half of them end in what was on the disk before.
    const std::size_t sector = std::min<std::size_t>(512, torn.size());
    if (i % 2 == 1)
      for (std::size_t k = torn.size() - sector; k < torn.size(); ++k) torn[k] = static_cast<char>(random.below(256));
    static_cast<void>(folder.write("torn.vantage-wal", torn));
    const Session session = Session::open(copy, SessionAccess::Write);
    EXPECT_EQ(session.losses(), std::vector<Loss>()) << i;
    const std::size_t steps = session.history().size();
    ASSERT_GE(steps, 1U) << i;
    ASSERT_LE(steps, hashes.size()) << i;
    EXPECT_EQ(stateHash(*session.state()), hashes[session.history().cursor()]) << i;
    cutShort += steps < hashes.size() ? 1 : 0;
  }
  EXPECT_GT(cutShort, 20U);
}

// Nothing in a file can make the program wait for ever.
TEST(Database, AStatementThatDoesNotEndIsGivenUp) {
  Database database = Database::inMemory("slow.vantage");
  expectError<IoError>(
      [&] { database.run("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT max(i) FROM n"); },
      {"slow.vantage", "given up"});
  database.run("CREATE TABLE t(a)");
}

}  // namespace
}  // namespace vantage
