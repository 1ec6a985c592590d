#pragma once

#include "scanner/device.h"
#include "scanner/positioner.h"
#include "scanner/range_image.h"

namespace vantage {

/// What measures distances: it takes range images and moves nothing.
class RangeSensor : public Device {
 public:
  /// One range image of what stands before it now, in scanner coordinates: its rays and a distance for each. Where it
  /// was taken from is for who moves the table to say (see scanFrom): pose and station are those of an empty image.
  /// @throws DeviceError that says what the operator can do about it, also when it is not ready; Cancelled
  [[nodiscard]] virtual RangeImage capture(const Progress& progress) = 0;

  /// Hears before a move begins that a scan is wanted after it: what a scanner that works by itself delivers from now
  /// on may be that scan. Without it only what comes once capture() waits.
  virtual void announceMove() {}

  /// Hears before every capture where the positioner came to stand. Most sensors need not know; what runs a program or
  /// replays scans does.
  virtual void standAt(const ReachedPose& /*pose*/) {}
};

}  // namespace vantage
