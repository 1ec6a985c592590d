#pragma once

#include <memory>
#include <optional>

#include "devices/device_factory.h"
#include "set_up.h"

namespace vantage {

/// Real devices stay open from one job to the next: opening a turntable anew restarts it. One thread at a time.
class RigKeeper {
 public:
  explicit RigKeeper(DeviceFactory factory) : factory_(std::move(factory)) {}

  /// The open devices of a set-up: those of the last time, when they can still be used.
  /// @param stands where the table stands, if it has to be opened. @throws DeviceError, Cancelled
  [[nodiscard]] Rig open(const SharedSetUp& setUp, std::int64_t scansBefore, const TableStand& stands,
                         const Progress& progress) {
    if (!std::holds_alternative<RealDevices>(*setUp->devices))
      return factory_.open(*setUp->devices, scansBefore, progress);
    if (rig_ && of_ == setUp && !rig_->sensor->notReady() && !rig_->positioner->notReady()) return *rig_;
    rig_.reset();
    RealDevices devices = std::get<RealDevices>(*setUp->devices);
    devices.stands = stands;
    rig_ = factory_.open(devices, scansBefore, progress);
    of_ = setUp;
    return *rig_;
  }

  /// After a failure they are opened anew the next time.
  void drop() { rig_.reset(); }

 private:
  DeviceFactory factory_;
  std::optional<Rig> rig_;
  SharedSetUp of_;
};

}  // namespace vantage
