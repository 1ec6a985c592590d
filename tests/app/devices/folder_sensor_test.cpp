#include "devices/folder_sensor.h"

#include <filesystem>
#include <fstream>
#include <stop_token>
#include <thread>

#include "app/devices/waiting.h"
#include "core/io/expect_error.h"
#include "devices/folder_watch.h"
#include "support/test_data.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using testing::expectError;
using testing::TemporaryFolder;
using testing::Waiting;
using testing::Writing;
using testing::WrittenScan;

constexpr std::chrono::seconds kSoon{10};
constexpr std::chrono::milliseconds kLater{400};

class FolderSensorTest : public ::testing::Test {
 protected:
  FolderSensorTest() {
    options_.folder = folder_.file("");
    options_.rest = std::chrono::milliseconds(150);
    options_.interval = std::chrono::milliseconds(20);
  }
  FolderSensor& sensor() {
    if (!sensor_) {
      sensor_ = std::make_unique<FolderSensor>(options_, profile_);
      sensor_->open({});
    }
    return *sensor_;
  }
  std::unique_ptr<Waiting<RangeImage>> capture() {
    auto waiting = std::make_unique<Waiting<RangeImage>>(
        [&sensor = sensor()](const Progress& progress) { return sensor.capture(progress); });
    EXPECT_TRUE(waiting->says("waiting for a range file in " + options_.folder));
    return waiting;
  }
  void expectScan(const RangeImage& image) const {
    ASSERT_EQ(image.rays, profile_->rays);
    for (std::size_t i = 0; i < scan_.range.size(); ++i) {
      ASSERT_EQ(image.valid(i), scan_.points[i].has_value());
      if (image.valid(i)) {
        ASSERT_NEAR(image.range[i], scan_.range[i], 2e-3);
      }
    }
  }
  void expectTaken(Waiting<RangeImage>& waiting, const std::string& name) {
    ASSERT_TRUE(waiting.isOver(kSoon));
    expectScan(waiting.get());
    EXPECT_EQ(fs::path(sensor().lastFile()).filename(), name);
  }

  TemporaryFolder folder_;
  std::shared_ptr<const ScannerProfile> profile_ = std::make_shared<const ScannerProfile>(testing::stripeProfile());
  WrittenScan scan_{*profile_};
  std::string text_ = testing::plyText(scan_, {}, true);
  FolderSensorOptions options_;
  std::unique_ptr<FolderSensor> sensor_;
};

TEST_F(FolderSensorTest, AFileThatWasBeingWrittenWhenTheMoveBeganIsOfTheScanBefore) {
  static_cast<void>(sensor());
  static_cast<void>(folder_.write("before.ply", text_.substr(0, text_.size() / 2)));
  static_cast<void>(folder_.write("renamed.ply.part", text_));
  sensor().announceMove();
  static_cast<void>(folder_.write("before.ply", text_));
  fs::rename(folder_.file("renamed.ply.part"), folder_.file("renamed.ply"));
  const auto waiting = capture();
  EXPECT_FALSE(waiting->isOver(std::chrono::milliseconds(400)));
  static_cast<void>(folder_.write("after.ply", text_));
  expectTaken(*waiting, "after.ply");
}

TEST_F(FolderSensorTest, AFileThatWasBegunWhileTheTableTurnedIsOfNoPosition) {
  static_cast<void>(sensor());
  sensor().announceMove();
  static_cast<void>(folder_.write("during.ply", text_));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  sensor().standAt({0, Pose::Identity(), PoseSource::Reported, {}, std::chrono::system_clock::now()});
  ASSERT_EQ(sensor().refused().size(), 1U);
  EXPECT_NE(sensor().refused()[0].reason.find("during.ply: was begun while the table still turned"), std::string::npos);
  const auto waiting = capture();
  EXPECT_FALSE(waiting->isOver(kLater));
  static_cast<void>(folder_.write("after.ply", testing::plyText(scan_, {}, false)));
  expectTaken(*waiting, "after.ply");
}

TEST_F(FolderSensorTest, AFileThatCameWhenTheTableRestedMayComeBeforeThatIsKnown) {
  static_cast<void>(sensor());
  sensor().announceMove();
  const auto rested = std::chrono::system_clock::now() - std::chrono::seconds(1);
  static_cast<void>(folder_.write("soon.ply", text_));
  sensor().standAt({0, Pose::Identity(), PoseSource::Reported, {}, rested});
  expectTaken(*capture(), "soon.ply");
}

TEST_F(FolderSensorTest, ProgramsMayWriteTheSameFileAgainAndAgain) {
  const auto first = capture();
  static_cast<void>(folder_.write("scan.ply", text_));
  expectTaken(*first, "scan.ply");
  sensor().announceMove();
  static_cast<void>(folder_.write("scan.ply", testing::plyText(scan_, {}, false)));
  expectTaken(*capture(), "scan.ply");
}

TEST_F(FolderSensorTest, TakesAFileThatCame) {
  const auto waiting = capture();
  static_cast<void>(folder_.write("a.ply", text_));
  expectTaken(*waiting, "a.ply");
  EXPECT_TRUE(sensor().refused().empty());
  EXPECT_TRUE(fs::exists(folder_.file("a.ply")));
}

TEST_F(FolderSensorTest, LeavesWhatWasThereBeforeUnlessItIsAskedFor) {
  options_.rest = std::chrono::milliseconds(50);
  const std::string old = folder_.write("old.ply", text_);
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
  {
    const auto waiting = capture();
    EXPECT_FALSE(waiting->isOver(kLater));
  }
  options_.existing = true;
  sensor_.reset();
  expectScan(sensor().capture({}));
}

TEST_F(FolderSensorTest, WaitsUntilAFileIsWhole) {
  const auto waiting = capture();
  static_cast<void>(folder_.write("a.ply", text_.substr(0, text_.size() / 2)));
  EXPECT_TRUE(waiting->says("a.ply"));
  ASSERT_EQ(sensor().refused().size(), 1U);
  EXPECT_NE(sensor().refused()[0].reason.find("a.ply"), std::string::npos);
  static_cast<void>(folder_.write("a.ply", text_));
  expectTaken(*waiting, "a.ply");
  EXPECT_TRUE(sensor().refused().empty());
}

TEST_F(FolderSensorTest, WaitsWhileAFileGrows) {
  const auto waiting = capture();
  // Without a count every beginning of it that ends with a line is a list of points.
  const std::string points = testing::xyzText(scan_, {}, false, false);
  std::ofstream file(folder_.file("a.xyz"));
  for (std::size_t begin = 0; begin < points.size();) {
    const std::size_t end = std::min(points.find('\n', begin + points.size() / 10), points.size() - 1) + 1;
    file << points.substr(begin, end - begin) << std::flush;
    begin = end;
    std::this_thread::sleep_for(options_.rest / 3);
  }
  file.close();
  expectTaken(*waiting, "a.xyz");
}

TEST_F(FolderSensorTest, DoesNotBelieveALastLineWithoutItsEnd) {
  const auto waiting = capture();
  const std::string points = testing::xyzText(scan_, {}, false, false);
  static_cast<void>(folder_.write("a.xyz", points.substr(0, points.find('\n', points.size() / 2))));
  EXPECT_TRUE(waiting->says("a.xyz: has no line end"));
  static_cast<void>(folder_.write("a.xyz", points));
  expectTaken(*waiting, "a.xyz");
}

TEST_F(FolderSensorTest, TakesAFileThatIsRenamedIntoPlaceAtOnce) {
  options_.rest = std::chrono::hours(1);
  const auto waiting = capture();
  static_cast<void>(folder_.write("a.ply.part", text_));
  EXPECT_FALSE(waiting->isOver(kLater));
  fs::rename(folder_.file("a.ply.part"), folder_.file("a.ply"));
  expectTaken(*waiting, "a.ply");
}

TEST_F(FolderSensorTest, IgnoresWhatLiesBesideAScan) {
  const auto waiting = capture();
  for (const char* name : {".a.ply", "a.ply.tmp", "a.thumb.png", "scanner.log", "a.ply.lock", "a.json", "Thumbs.db"})
    static_cast<void>(folder_.write(name, text_));
  EXPECT_FALSE(waiting->isOver(kLater));
  EXPECT_TRUE(sensor().refused().empty());
  fs::create_directory(folder_.file("today"));
  static_cast<void>(folder_.write("today/b.ply", text_));
  expectTaken(*waiting, "b.ply");
}

TEST_F(FolderSensorTest, TakesTheSameContentOnce) {
  {
    const auto waiting = capture();
    static_cast<void>(folder_.write("a.ply", text_));
    expectTaken(*waiting, "a.ply");
  }
  const auto waiting = capture();
  static_cast<void>(folder_.write("b.ply", text_));
  EXPECT_TRUE(waiting->says("b.ply: has the content of a.ply"));
  EXPECT_FALSE(waiting->isOver(kLater));
  static_cast<void>(folder_.write("c.ply", testing::plyText(scan_, {}, false)));
  expectTaken(*waiting, "c.ply");
}

TEST_F(FolderSensorTest, TakesOfSeveralTheOldest) {
  const auto now = fs::file_time_type::clock::now();
  options_.existing = true;
  fs::last_write_time(folder_.write("a.ply", text_ + " "), now);
  fs::last_write_time(folder_.write("b.ply", testing::plyText(scan_, {}, false)), now - std::chrono::seconds(5));
  fs::last_write_time(folder_.write("c.ply", text_), now - std::chrono::seconds(5));
  for (const char* name : {"b.ply", "c.ply", "a.ply"}) {
    expectScan(sensor().capture({}));
    EXPECT_EQ(fs::path(sensor().lastFile()).filename(), name);
  }
}

TEST_F(FolderSensorTest, OfSeveralThatCameForOneTurnTheOldestIsTakenAndTheOthersAreNamed) {
  sensor().announceMove();
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(folder_.write("late.ply", testing::plyText(scan_, {}, false)), now);
  fs::last_write_time(folder_.write("early.ply", text_), now - std::chrono::seconds(1));
  std::string said;
  const Progress told(
      [&](double /*fraction*/, std::string_view step) {
        if (step.starts_with("took")) said = step;
      },
      {}, 1);
  // Both are to have come to rest.
  std::this_thread::sleep_for(2 * options_.rest);
  expectScan(sensor().capture(told));
  EXPECT_EQ(said, "took early.ply; more files wait: late.ply");
  EXPECT_TRUE(sensor().refused().empty());
  sensor().announceMove();
  ASSERT_EQ(sensor().refused().size(), 1U);
  EXPECT_NE(sensor().refused()[0].reason.find("late.ply: came beside early.ply"), std::string::npos);
  const auto waiting = capture();
  EXPECT_FALSE(waiting->isOver(kLater));
  static_cast<void>(folder_.write("next.ply", text_ + " "));
  expectTaken(*waiting, "next.ply");
}

// A scan is stopped while its file is still coming to rest; the next one finds it at rest.
class StoppedFolderSensorTest : public FolderSensorTest {
 protected:
  void stopWhileAFileComesToRest() {
    sensor().announceMove();
    sensor().standAt(here_);
    const auto waiting = capture();
    static_cast<void>(folder_.write("scan.ply", text_));
    waiting->stop();
    ASSERT_TRUE(waiting->isOver(kSoon));
    EXPECT_THROW(static_cast<void>(waiting->get()), Cancelled);
    std::this_thread::sleep_for(2 * options_.rest);
  }
  // The next scan, from a place.
  void scanAgain(const ReachedPose& pose) {
    sensor().announceMove();
    sensor().standAt(pose);
  }
  void expectRefused() {
    ASSERT_EQ(sensor().refused().size(), 1U);
    EXPECT_NE(sensor().refused()[0].reason.find("scan.ply: came for a scan that was stopped"), std::string::npos);
    const auto waiting = capture();
    EXPECT_FALSE(waiting->isOver(kLater));
    static_cast<void>(folder_.write("scan.ply", text_ + " "));
    expectTaken(*waiting, "scan.ply");
    EXPECT_TRUE(sensor().refused().empty());
  }

  ReachedPose here_{0, Pose::Identity(), PoseSource::ByHand, {}, {}};
};

TEST_F(StoppedFolderSensorTest, TheNextScanFromThereTakesTheFile) {
  stopWhileAFileComesToRest();
  scanAgain(here_);
  expectScan(sensor().capture({}));
  EXPECT_EQ(fs::path(sensor().lastFile()).filename(), "scan.ply");
  EXPECT_TRUE(sensor().refused().empty());
}

TEST_F(StoppedFolderSensorTest, FromElsewhereTheFileIsRefusedAndTakenWhenItIsSavedAgain) {
  stopWhileAFileComesToRest();
  ReachedPose elsewhere = here_;
  elsewhere.T_table_scanner.rotate(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
  scanAgain(elsewhere);
  expectRefused();
}

TEST_F(StoppedFolderSensorTest, ATableThatAlwaysTurnsHasLeftTheFileBehind) {
  options_.tableAlwaysTurns = true;
  stopWhileAFileComesToRest();
  scanAgain(here_);
  expectRefused();
}

TEST_F(StoppedFolderSensorTest, AMoveThatFailedLeavesTheFileOfNoKnownPlace) {
  stopWhileAFileComesToRest();
  sensor().announceMove();
  scanAgain(here_);
  expectRefused();
}

// At whichever of the reports of reading the stop comes.
TEST_F(FolderSensorTest, AStopWhileAFileIsTakenLeavesItForTheNextScan) {
  sensor().announceMove();
  static_cast<void>(folder_.write("scan.ply", text_));
  std::this_thread::sleep_for(2 * options_.rest);
  int stopped = 0;
  std::optional<RangeImage> image;
  while (!image && stopped < 1000) {
    std::stop_source stop;
    int reports = 0;
    const Progress progress(
        [&](double /*fraction*/, std::string_view step) {
          if (!step.starts_with("waiting") && reports++ == stopped) stop.request_stop();
        },
        stop.get_token(), 1);
    try {
      image = sensor().capture(progress);
    } catch (const Cancelled&) {
      ++stopped;
    }
  }
  EXPECT_GE(stopped, 1);
  ASSERT_TRUE(image);
  expectScan(*image);
}

TEST_F(FolderSensorTest, AsksForAUnitAndTakesTheFileWhenItIsSaid) {
  Writing metres;
  metres.unit = 0.001;
  {
    const auto waiting = capture();
    static_cast<void>(folder_.write("a.ply", testing::plyText(scan_, metres, true)));
    ASSERT_TRUE(waiting->isOver(kSoon));
    expectError<DeviceError>([&] { static_cast<void>(waiting->get()); }, {"a.ply", "say --unit m"});
  }
  ScanReadingOptions reading;
  reading.unit = 1000.0;
  sensor().setReading(reading);
  expectScan(sensor().capture({}));
}

TEST_F(FolderSensorTest, SaysWhyNothingCameInTime) {
  options_.deadline = std::chrono::milliseconds(300);
  expectError<DeviceError>([&] { static_cast<void>(sensor().capture({})); }, {options_.folder, "within 0.3 s"});
  const auto waiting = capture();
  static_cast<void>(folder_.write("a.ply", "ply\nbroken"));
  ASSERT_TRUE(waiting->isOver(kSoon));
  expectError<DeviceError>([&] { static_cast<void>(waiting->get()); }, {"no range file", "a.ply"});
}

TEST_F(FolderSensorTest, AnswersAStopAndShowsThatItIsAlive) {
  const auto waiting = capture();
  const int before = waiting->reports();
  EXPECT_FALSE(waiting->isOver(kLater));
  EXPECT_GT(waiting->reports(), before);
  waiting->stop();
  ASSERT_TRUE(waiting->isOver(kSoon));
  EXPECT_THROW(static_cast<void>(waiting->get()), Cancelled);
}

TEST_F(FolderSensorTest, SaysWhenTheFolderIsMissingOrGoesAway) {
  {
    const auto waiting = capture();
    fs::remove_all(options_.folder);
    ASSERT_TRUE(waiting->isOver(kSoon));
    expectError<DeviceError>([&] { static_cast<void>(waiting->get()); }, {options_.folder, "gone", "bring it back"});
  }
  sensor_.reset();
  expectError<DeviceError>([&] { static_cast<void>(sensor()); }, {"no such folder"});
}

TEST(FolderWatch, KnowsWhatIsNoScan) {
  for (const char* name : {".hidden.ply", "a.part", "a.PLY.TMP", "preview.png", "a.log", "a~", "a.jpg"})
    EXPECT_TRUE(FolderWatch::isIgnored(name)) << name;
  for (const char* name : {"a.ply", "Scan 7.PCD", "a.xyz", "partner.ply", "a.e57"})
    EXPECT_FALSE(FolderWatch::isIgnored(name)) << name;
}

TEST(FolderWatch, ChangesItsStampWithTheFileOrWhatBelongsToIt) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.png", "1");
  const FileStamp before = stampOf(file);
  EXPECT_EQ(stampOf(file), before);
  static_cast<void>(folder.write("a.json", "{}"));
  EXPECT_FALSE(stampOf(file) == before);
  EXPECT_EQ(stampOf(folder.file("none.png")), FileStamp{});
}

}  // namespace
}  // namespace vantage
