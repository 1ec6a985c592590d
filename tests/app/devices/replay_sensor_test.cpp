#include "devices/replay_sensor.h"

#include <filesystem>

#include "core/io/expect_error.h"
#include "session/session.h"
#include "support/test_data.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;
using testing::WrittenScan;

class ReplaySensorTest : public ::testing::Test {
 protected:
  // A scan of one sample, whose range tells it from others.
  static RangeImage numbered(const ScannerProfile& profile, float range, std::optional<int> position) {
    RangeImage image;
    image.rays = profile.rays;
    image.range.assign(profile.rays->size(), kNoSample);
    image.range[0] = range;
    image.station.position = position;
    return image;
  }
  static ReachedPose at(int position) { return {position, Pose::Identity(), PoseSource::Commanded, {}}; }
  static float takenAt(ReplaySensor& sensor, int position) {
    sensor.standAt(at(position));
    return sensor.capture({}).range[0];
  }

  TemporaryFolder folder_;
  std::shared_ptr<const ScannerProfile> profile_ = std::make_shared<const ScannerProfile>(testing::stripeProfile());
  WrittenScan scan_{*profile_};
};

TEST_F(ReplaySensorTest, GivesTheScansOfASessionByPosition) {
  const std::string path = folder_.file("s.vantage");
  const ProfileSource source =
      readProfileSource((testing::sourceFolder() / "resources/scanners/depth_camera.json").string());
  const auto profile = std::make_shared<const ScannerProfile>(parseProfile(source));
  {
    Session session = Session::create(path, {source, {}});
    static_cast<void>(session.keepScan(numbered(*profile, 201.0F, 3)));
    static_cast<void>(session.keepScan(numbered(*profile, 202.0F, 5)));
    static_cast<void>(session.keepScan(numbered(*profile, 203.0F, 3)));
  }
  ReplaySensor sensor(path, profile);
  sensor.open({});
  EXPECT_EQ(takenAt(sensor, 5), 202.0F);
  EXPECT_EQ(takenAt(sensor, 3), 201.0F);
  EXPECT_EQ(takenAt(sensor, 3), 203.0F);
  expectError<DeviceError>([&] { static_cast<void>(takenAt(sensor, 3)); }, {path, "position 3", "again already"});
  expectError<DeviceError>([&] { static_cast<void>(takenAt(sensor, 4)); }, {"no scan of position 4"});
  sensor.close();
  sensor.open({});
  expectError<DeviceError>([&] { static_cast<void>(takenAt(sensor, 4)); }, {"no scan of position 4", "left of 3, 5"});
  sensor.standAt(at(5));
  const RangeImage image = sensor.capture({});
  EXPECT_FALSE(image.station.position);
  EXPECT_EQ(image.poseKnownBy, PoseSource::Unknown);
  ReplaySensor wrong(path, profile_);
  wrong.open({});
  expectError<DeviceError>([&] { static_cast<void>(takenAt(wrong, 3)); }, {"another scanner", "240 x 320"});
}

TEST_F(ReplaySensorTest, GivesTheFilesOfAFolderByTheNameOrInOrder) {
  const std::string text = testing::plyText(scan_, {}, true);
  static_cast<void>(folder_.write("mug_pos7.ply", text));
  static_cast<void>(folder_.write("mug_position_12.ply", text.substr(0, text.size() / 2)));
  static_cast<void>(folder_.write("notes.log", "x"));
  ReplaySensor sensor(folder_.file(""), profile_);
  sensor.open({});
  sensor.standAt(at(7));
  EXPECT_GT(sensor.capture({}).sampleCount(), 100U);
  expectError<DeviceError>([&] { static_cast<void>(takenAt(sensor, 12)); }, {"mug_position_12.ply"});
  expectError<DeviceError>([&] { static_cast<void>(takenAt(sensor, 1)); }, {"no scan of position 1", "12"});
  static_cast<void>(folder_.write("a.ply", text));
  sensor.close();
  sensor.open({});
  sensor.standAt(at(1));
  EXPECT_GT(sensor.capture({}).sampleCount(), 100U);
}

TEST_F(ReplaySensorTest, SaysWhenThereIsNothingToReplay) {
  ReplaySensor missing(folder_.file("none.vantage"), profile_);
  expectError<DeviceError>([&] { missing.open({}); }, {"none.vantage"});
  ReplaySensor empty(folder_.file(""), profile_);
  expectError<DeviceError>([&] { empty.open({}); }, {"no scans"});
  EXPECT_TRUE(empty.notReady());
}

}  // namespace
}  // namespace vantage
