#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/camera_model.h"
#include "devices/depth_average.h"
#include "devices/rig_description.h"
#include "scanner/range_sensor.h"

namespace vantage {

/// A depth camera that OpenNI2 found.
struct CameraInfo {
  std::string uri;
  std::string vendor;
  std::string name;
  std::optional<CameraModel> model;  ///< nothing for what cannot be used
  std::string problem;               ///< why it cannot be used; empty when it can
};

/// The cameras that are connected, in the order in which OpenNI2 has them. The first call, and the first camera that is
/// opened, start OpenNI2 for the rest of the process. While it loads its drivers it changes the working directory of
/// the whole process, which is put right again afterwards: no other thread should use a relative path meanwhile.
/// @throws DeviceError when OpenNI2 does not start, or the program was built without it; Cancelled
[[nodiscard]] std::vector<CameraInfo> connectedCameras(const Progress& progress = {});

/// The profile of a camera that is connected. @param columns of its images; unset: as it is set
/// @throws DeviceError when there is no such camera or it has no such images
[[nodiscard]] ProfileSource profileOfCamera(const OpenNi2Device& device, const CameraPlace& place,
                                            std::optional<int> columns = {}, const Progress& progress = {});

/// How a depth camera is read.
struct OpenNi2Options {
  int frames = 10;  ///< that make one range image
  DepthAverageOptions average;
  std::chrono::milliseconds settle{400};       ///< frames that come earlier may show the table before it stopped
  std::chrono::milliseconds silence{2'000};    ///< after which a camera that sends nothing is given up
  std::chrono::milliseconds comeback{10'000};  ///< for which one that was disconnected is waited for
};

/// A depth camera as a range sensor: it measures along the rays of a profile, see pixelsOfRays. It is asked for the
/// finest unit that it has, and for images that are not mirrored. One that was disconnected is opened anew when it is
/// back; one that freezes or repeats itself once.
/// @throws InvalidInput without frames
[[nodiscard]] std::shared_ptr<RangeSensor> makeOpenNi2Sensor(const OpenNi2Device& device,
                                                             std::shared_ptr<const ScannerProfile> profile,
                                                             const OpenNi2Options& options = {});

}  // namespace vantage
