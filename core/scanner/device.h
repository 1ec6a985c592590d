#pragma once

#include "base/progress.h"
#include "scanner/range_image.h"

namespace vantage {

/// Something that scans: moves to a position of its workspace and takes one range image there.
class ScannerDevice {
 public:
  virtual ~ScannerDevice() = default;

  /// One range image from a workspace position, with its nominal pose.
  /// @throws DeviceError, Cancelled
  [[nodiscard]] virtual RangeImage scan(int position, const Progress& progress) = 0;
};

}  // namespace vantage
