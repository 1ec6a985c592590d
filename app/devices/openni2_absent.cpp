#include "base/errors.h"
#include "devices/openni2_sensor.h"

namespace vantage {
namespace {

[[noreturn]] void refuse() {
  throw DeviceError(
      "this program was built without OpenNI2 and knows no depth cameras: install libopenni2-dev and build it again, "
      "or "
      "let a program of the camera's maker write range files");
}

}  // namespace

std::vector<CameraInfo> connectedCameras(const Progress& /*progress*/) {
  refuse();
}

ProfileSource profileOfCamera(const OpenNi2Device& /*device*/, const CameraPlace& /*place*/,
                              std::optional<int> /*columns*/, const Progress& /*progress*/) {
  refuse();
}

std::shared_ptr<RangeSensor> makeOpenNi2Sensor(const OpenNi2Device& /*device*/,
                                               std::shared_ptr<const ScannerProfile> /*profile*/,
                                               const OpenNi2Options& /*options*/) {
  refuse();
}

}  // namespace vantage
