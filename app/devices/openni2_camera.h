#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/camera_model.h"
#include "devices/depth_average.h"

namespace vantage {

/// A camera as OpenNI2 lists it.
struct ListedCamera {
  std::string uri;
  std::string vendor;
  std::string name;
};

/// What is connected now. Starts OpenNI2 the first time, for the rest of the process. @throws DeviceError
[[nodiscard]] std::vector<ListedCamera> listedCameras();

/// A depth camera of OpenNI2 that is open. The only door to the library.
class OpenNi2Camera {
 public:
  /// Whether images of a size will do.
  using SizeTest = std::function<bool(int columns, int rows)>;

  /// Opens a camera and lets it send images of a size that will do. Without a test it is looked at as it is set, and
  /// sends nothing.
  /// @throws DeviceError when there is no such camera, it has no depth sensor, no field of view or no such images
  explicit OpenNi2Camera(const ListedCamera& camera, const SizeTest& sizeWillDo = {});
  ~OpenNi2Camera();
  OpenNi2Camera(const OpenNi2Camera&) = delete;
  OpenNi2Camera& operator=(const OpenNi2Camera&) = delete;

  /// "Maker Name, serial number N".
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] const CameraModel& model() const;
  /// Millimetres per count of a depth.
  [[nodiscard]] double unit() const;
  /// Whether it was disconnected since it was opened.
  [[nodiscard]] bool isGone() const;

  /// The next frame, upper left pixel first; nothing when none came in time.
  /// @throws DeviceError when it cannot be read
  [[nodiscard]] std::optional<DepthFrame> next(std::chrono::milliseconds patience);

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};

}  // namespace vantage
