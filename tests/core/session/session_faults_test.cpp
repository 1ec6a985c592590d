#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <new>
#include <thread>

#include "acquisition/patient_scanner.h"
#include "base/errors.h"
#include "core/io/expect_error.h"
#include "faulty_storage.h"
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

// An acquisition whose second scan meets with something.
template <typename Meet>
void acquireMeeting(Session& session, const Meet& meet) {
  class Scanner final : public ScannerDevice {
   public:
    Scanner(Session& session, const Meet& meet)
        : scanner_(session.object(), session.profile(), {}, static_cast<int>(session.scanCount())), meet_(meet) {}
    RangeImage scan(int position, const Progress& progress) override {
      if (++scans_ == 2) meet_();
      return scanner_.scan(position, progress);
    }

   private:
    SimulatedScanner scanner_;
    const Meet& meet_;
    int scans_ = 0;
  };
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*session.profile()));
  Acquisition(session, {std::make_shared<Scanner>(session, meet), images}).runUntilTheEnd();
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
  SimulatedScanner scanner(testing::smallObject(), testing::smallProfile(), {});
  RangeImage image = scanner.scan(0, Progress());
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
  class Swapped final : public ScannerDevice {
   public:
    explicit Swapped(const std::shared_ptr<const ScannerProfile>& profile)
        : first_(testing::smallObject(), profile, {}),
          other_(testing::makeBox({-10, -40, 70}, {40, -20, 90}, 4), profile, {}) {}
    RangeImage scan(int position, const Progress& progress) override {
      return scans_++ == 0 ? first_.scan(position, progress) : other_.scan(position, progress);
    }

   private:
    SimulatedScanner first_;
    SimulatedScanner other_;
    int scans_ = 0;
  };
  Session session = createSmallSession(path(), threeViews());
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*session.profile()));
  Acquisition acquisition(session, {std::make_shared<Swapped>(session.profile()), images});
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

// A turntable that stops, until it is let go; with progress that it shows meanwhile.
class StuckScanner final : public ScannerDevice {
 public:
  explicit StuckScanner(std::shared_ptr<std::atomic<bool>> go, bool alive) : go_(std::move(go)), alive_(alive) {}
  RangeImage scan(int position, const Progress& progress) override {
    while (!*go_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (alive_) progress.checkpoint(0.5);
    }
    RangeImage image;
    image.station.position = position;
    return image;
  }

 private:
  std::shared_ptr<std::atomic<bool>> go_;
  bool alive_;
};

TEST(PatientScanner, GivesUpADeviceThatShowsNoSignOfLife) {
  const auto go = std::make_shared<std::atomic<bool>>(false);
  PatientScanner scanner(std::make_shared<StuckScanner>(go, false), std::chrono::milliseconds(100));
  expectError<DeviceError>([&] { static_cast<void>(scanner.scan(7, {})); }, {"not answered", "position 7"});
  expectError<DeviceError>([&] { static_cast<void>(scanner.scan(7, {})); }, {"start it again"});
  *go = true;
}

TEST(PatientScanner, WaitsForADeviceThatShowsProgress) {
  const auto go = std::make_shared<std::atomic<bool>>(false);
  PatientScanner scanner(std::make_shared<StuckScanner>(go, true), std::chrono::milliseconds(200));
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    *go = true;
  });
  EXPECT_EQ(scanner.scan(7, {}).station.position, 7);
}

TEST(PatientScanner, IsCancelledEvenWhenTheDeviceDoesNotListen) {
  const auto go = std::make_shared<std::atomic<bool>>(false);
  PatientScanner scanner(std::make_shared<StuckScanner>(go, false), std::chrono::hours(1));
  std::stop_source stop;
  std::jthread later([&] { stop.request_stop(); });
  EXPECT_THROW(static_cast<void>(scanner.scan(7, Progress({}, stop.get_token(), 1))), Cancelled);
  *go = true;
}

}  // namespace
}  // namespace vantage
