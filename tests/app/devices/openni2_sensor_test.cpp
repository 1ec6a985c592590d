#include "devices/openni2_sensor.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <thread>

#include "base/errors.h"
#include "devices/openni2_camera.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using namespace std::chrono_literals;
using testing::TemporaryFolder;

constexpr const char* kUri = "made-up://camera";

// Before the cameras of tests/app/devices/openni2_driver, which do as a file says. OpenNI2 and its driver are one for
// the whole process, and so is the file.
class OpenNi2Test : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* libraries = std::getenv("LD_LIBRARY_PATH");
    if (libraries == nullptr || std::string_view(libraries).find("openni2") == std::string_view::npos)
      GTEST_SKIP() << "OpenNI2 must be loaded from beside the driver of the tests: run this with ctest";
    camera("");
    ::setenv("VANTAGE_MADE_UP_CAMERA", script().c_str(), 1);
  }

  static std::string script() {
    static const TemporaryFolder folder;
    return folder.file("camera.txt");
  }
  // What the camera does from now on.
  static void camera(const std::string& words) {
    std::ofstream(script() + ".new") << words;
    std::filesystem::rename(script() + ".new", script());
  }

  static std::shared_ptr<const ScannerProfile> profile() {
    return std::make_shared<const ScannerProfile>(parseProfile(profileOfCamera({kUri}, {})));
  }
  static OpenNi2Options quick() {
    OpenNi2Options options;
    options.settle = 50ms;
    options.silence = 500ms;
    options.comeback = 1000ms;
    return options;
  }
  static std::shared_ptr<RangeSensor> opened(const OpenNi2Options& options = quick()) {
    auto sensor = makeOpenNi2Sensor({kUri}, profile(), options);
    sensor->open({});
    return sensor;
  }
  static std::string failureOf(RangeSensor& sensor) {
    try {
      static_cast<void>(sensor.capture({}));
    } catch (const DeviceError& e) {
      return e.what();
    }
    return "";
  }
  // The depth that the camera measures at a pixel, without noise.
  static double depthAt(int x, int y) { return 600.0 + 4.0 * x + 2.0 * y; }

  static double worstError(const RangeImage& image) {
    const CameraInfo camera = connectedCameras()[1];
    EXPECT_TRUE(camera.model) << camera.problem;
    const CameraModel model = camera.model.value();
    double worst = image.sampleCount() > 0 ? 0.0 : 1e9;
    for (int r = 0; r < image.rays->rows(); ++r)
      for (int c = 0; c < image.rays->columns(); ++c) {
        const std::size_t i = image.rays->index(r, c);
        if (!image.valid(i)) continue;
        const double range = depthAt(c + 1, r + 1) * pixelDirection(model, c + 1, r + 1).norm();
        worst = std::max(worst, std::abs(range - static_cast<double>(image.range[i])));
      }
    return worst;
  }
};

TEST_F(OpenNi2Test, ListsTheCamerasAndWhyOneCannotBeUsed) {
  const auto folder = std::filesystem::current_path();
  const std::vector<CameraInfo> cameras = connectedCameras();
  EXPECT_EQ(std::filesystem::current_path(), folder);
  ASSERT_EQ(cameras.size(), 2U);
  EXPECT_EQ(cameras[0].name, "Blind Camera");
  EXPECT_NE(cameras[0].problem.find("0 degrees"), std::string::npos) << cameras[0].problem;
  EXPECT_FALSE(cameras[0].model);
  EXPECT_EQ(cameras[1].uri, kUri);
  EXPECT_EQ(cameras[1].vendor, "Made-up");
  EXPECT_EQ(cameras[1].problem, "");
  EXPECT_EQ(cameras[1].model->columns, 32);
  EXPECT_NEAR(cameras[1].model->horizontalFov, 0.9, 1e-6);
  EXPECT_EQ(listedCameras().size(), 2U);
}

TEST_F(OpenNi2Test, MeasuresAlongTheRaysOfItsProfile) {
  const auto sensor = opened();
  EXPECT_FALSE(sensor->notReady());
  EXPECT_EQ(sensor->identity(), "depth camera Made-up Depth Camera, serial number 0815");
  const RangeImage image = sensor->capture({});
  EXPECT_EQ(image.sampleCount(), 31U * 23U - 1U);
  EXPECT_LT(worstError(image), 1.0);
}

TEST_F(OpenNi2Test, ManyFramesAreBetterThanOneAndOutliersDoNotCount) {
  camera("flying");
  OpenNi2Options options = quick();
  options.frames = 21;
  EXPECT_LT(worstError(opened(options)->capture({})), 1.0);
}

TEST_F(OpenNi2Test, TakesTheFinerUnitAndTurnsMirroredImagesRound) {
  camera("tenths mirrored");
  EXPECT_EQ(OpenNi2Camera({kUri, "", ""}).unit(), 1.0) << "as it is set";
  EXPECT_EQ(OpenNi2Camera({kUri, "", ""}, [](int, int) { return true; }).unit(), 0.1);
  const auto sensor = opened();
  EXPECT_LT(worstError(sensor->capture({})), 1.0);
}

TEST_F(OpenNi2Test, WithoutANameTheFirstThatCanBeUsedIsTaken) {
  const auto sensor = makeOpenNi2Sensor({}, profile(), quick());
  sensor->open({});
  EXPECT_NE(sensor->identity().find("Depth Camera"), std::string::npos);
}

TEST_F(OpenNi2Test, ACameraThatIsNotThereIsASentence) {
  EXPECT_EQ(*makeOpenNi2Sensor({kUri}, profile(), quick())->notReady(), "it is not open");
  const auto other = makeOpenNi2Sensor({"made-up://other"}, profile(), quick());
  EXPECT_THROW(other->open({}), DeviceError);
  const auto blind = makeOpenNi2Sensor({"made-up://blind"}, profile(), quick());
  EXPECT_THROW(blind->open({}), DeviceError);
  OpenNi2Options none;
  none.frames = 0;
  EXPECT_THROW(static_cast<void>(makeOpenNi2Sensor({kUri}, profile(), none)), InvalidInput);
}

TEST_F(OpenNi2Test, AProfileOfAnotherCameraIsRefused) {
  auto other = *profile();
  other.rays = parseProfile(profileOf({64, 48, 0.9, 0.7}, "Other", {})).rays;
  const auto sensor = makeOpenNi2Sensor({kUri}, std::make_shared<const ScannerProfile>(other), quick());
  try {
    sensor->open({});
    FAIL() << "opened";
  } catch (const DeviceError& e) {
    EXPECT_NE(std::string(e.what()).find("32 x 24"), std::string::npos) << e.what();
  }
}

TEST_F(OpenNi2Test, FramesFromBeforeTheStopDoNotCount) {
  const auto sensor = opened();
  static_cast<void>(sensor->capture({}));
  camera("moved");
  const RangeImage image = sensor->capture({});
  EXPECT_GT(image.sampleCount(), 500U);
  EXPECT_NEAR(worstError(image), 50.0, 10.0);
}

TEST_F(OpenNi2Test, IsOpenedAnewWhenItComesBack) {
  const auto sensor = opened();
  camera("gone");
  std::jthread back([] {
    std::this_thread::sleep_for(300ms);
    camera("");
  });
  EXPECT_LT(worstError(sensor->capture({})), 1.0);
  EXPECT_FALSE(sensor->notReady());
}

TEST_F(OpenNi2Test, ACameraThatStaysAwayIsASentenceAndCanComeBackLater) {
  const auto sensor = opened();
  camera("gone");
  EXPECT_NE(failureOf(*sensor).find("disconnected"), std::string::npos);
  EXPECT_NE(sensor->notReady()->find("plug it in again"), std::string::npos);
  camera("");
  while (sensor->notReady()) std::this_thread::sleep_for(10ms);
  EXPECT_LT(worstError(sensor->capture({})), 1.0);
}

TEST_F(OpenNi2Test, AFrozenACoveredAndARepeatingCameraAreToldApart) {
  const auto sensor = opened();
  camera("frozen");
  EXPECT_NE(failureOf(*sensor).find("no picture"), std::string::npos);
  camera("black");
  EXPECT_NE(failureOf(*sensor).find("sees nothing"), std::string::npos);
  camera("repeating");
  EXPECT_NE(failureOf(*sensor).find("same picture"), std::string::npos);
  camera("");
  EXPECT_LT(worstError(sensor->capture({})), 1.0);
}

TEST_F(OpenNi2Test, AStopIsAnsweredAlsoWhenNothingComes) {
  OpenNi2Options patient = quick();
  patient.silence = 60s;
  const auto sensor = opened(patient);
  camera("frozen");
  std::stop_source stop;
  std::jthread stopper([&] {
    std::this_thread::sleep_for(200ms);
    stop.request_stop();
  });
  EXPECT_THROW(static_cast<void>(sensor->capture(Progress({}, stop.get_token(), 1))), Cancelled);
}

}  // namespace
}  // namespace vantage
