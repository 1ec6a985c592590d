#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/errors.h"
#include "devices/openni2_sensor.h"
#include "scanner/scan_cut.h"
#include "support/test_data.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

// A laboratory's camera is asked for by the environment variable VANTAGE_LAB, which names the folder where it was
// built. OpenNI2 must be loaded from beside its driver, so the test runs itself again with another environment.
int runAgain(const std::string& test, const std::string& camera, const std::string& library) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("LAB_CAMERA", camera.c_str(), 1);
    ::setenv("LD_LIBRARY_PATH", library.c_str(), 1);
    const std::string filter = "--gtest_filter=" + test;
    ::execl("/proc/self/exe", "test_depth_cameras", filter.c_str(), static_cast<char*>(nullptr));
    std::_Exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

CameraPlace place() {
  return {{450, 0, 250}, {0, 0, 60}, Vec3(75, 0, 0), 36};
}

class LabCamera : public ::testing::Test {
 protected:
  // Whether this is the run before the camera. @param faults as its configuration has them
  [[nodiscard]] static bool isBefore(const std::string& faults) {
    if (std::getenv("LAB_CAMERA") != nullptr) return true;
    const char* lab = std::getenv("VANTAGE_LAB");
    if (lab == nullptr || !fs::exists(fs::path(lab) / "libLabCamera.so.0")) {
      skip_ = true;
      return false;
    }
    const TemporaryFolder folder;
    const std::string library = folder.file("openni");
    const std::string lay = "'" + (fs::path(lab) / "lab_openni2_dir").string() + "' '" + library + "' > /dev/null";
    EXPECT_EQ(std::system(lay.c_str()), 0);
    const std::string mesh = (testing::sourceFolder() / "resources/objects/mug.ply").string();
    const std::string camera = folder.write(
        "camera.json",
        R"({"mesh": ")" + mesh + R"(", "angle_deg": 20, "width": 320, "height": 240, "faults": )" + faults + "}");
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    EXPECT_EQ(runAgain(std::string(info->test_suite_name()) + "." + info->name(), camera, library), 0);
    return false;
  }
  static inline bool skip_ = false;
};

#define VANTAGE_BEFORE_THE_CAMERA(faults)                                              \
  if (!isBefore(faults)) {                                                             \
    if (skip_) GTEST_SKIP() << "no laboratory: set VANTAGE_LAB to where it was built"; \
    return;                                                                            \
  }

ScannerProfile labProfile() {
  return parseProfile(profileOfCamera({}, place(), 320));
}

TEST_F(LabCamera, SeesTheTableTopWhereItIs) {
  VANTAGE_BEFORE_THE_CAMERA("[]");
  const auto profile = std::make_shared<const ScannerProfile>(labProfile());
  const auto sensor = makeOpenNi2Sensor({}, profile);
  sensor->open({});
  RangeImage image = sensor->capture({});
  image.poseKnownBy = PoseSource::Reported;
  EXPECT_GT(image.sampleCount(), 10'000U);
  // Of the table beside the object: its height is that of the plane.
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    if (!image.valid(i)) continue;
    const Vec3 p = image.point(i);
    if (p.head<2>().norm() < 90.0 || p.head<2>().norm() > 140.0 || std::abs(p.z()) > 5.0) continue;
    sum += p.z();
    count += 1.0;
  }
  ASSERT_GT(count, 1000.0);
  EXPECT_NEAR(sum / count, 0.0, 0.3);
  // Nothing but the object is left.
  const auto reasons = cutOf(image, {cutSceneOf(*profile), cutForRealScanners()});
  const RangeImage cut = withoutCut(image, reasons);
  EXPECT_GT(cut.sampleCount(), 1000U);
  double outside = 0.0;
  for (std::size_t i = 0; i < cut.range.size(); ++i)
    if (cut.valid(i) && cut.point(i).head<2>().norm() > 85.0) outside += 1.0;
  EXPECT_LT(outside, 0.005 * static_cast<double>(cut.sampleCount()));
  RecordProperty("table_height_um", static_cast<int>(1000.0 * sum / count));
}

TEST_F(LabCamera, ComesBackAfterItWasUnplugged) {
  // Every stream that is opened counts its frames anew, and so is unplugged again and again.
  VANTAGE_BEFORE_THE_CAMERA(R"([{"at_frame": 40, "do": "disconnect", "back_after_s": 1}])");
  OpenNi2Options options;
  options.frames = 5;
  options.settle = std::chrono::milliseconds(100);
  const auto sensor = makeOpenNi2Sensor({}, std::make_shared<const ScannerProfile>(labProfile()), options);
  sensor->open({});
  for (int scan = 0; scan < 8; ++scan) EXPECT_GT(sensor->capture({}).sampleCount(), 10'000U) << scan;
}

TEST_F(LabCamera, ABlackPictureIsASentence) {
  VANTAGE_BEFORE_THE_CAMERA(R"([{"at_frame": 1, "do": "black"}])");
  const auto sensor = makeOpenNi2Sensor({}, std::make_shared<const ScannerProfile>(labProfile()));
  sensor->open({});
  EXPECT_THROW(static_cast<void>(sensor->capture({})), DeviceError);
}

}  // namespace
}  // namespace vantage
