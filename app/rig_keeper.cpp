#include "rig_keeper.h"

#include <chrono>

namespace vantage {
namespace {

constexpr std::chrono::milliseconds kSlice{20};

}  // namespace

void RigKeeper::Use::drop() {
  keeper_->rig_.reset();
}

// What else was chosen has no say in which devices they are.
bool RigKeeper::keeps(const SetUp& setUp) const {
  return rig_ && of_ && of_->choice.rig == setUp.choice.rig && of_->profile == setUp.profile;
}

RigKeeper::Use RigKeeper::open(const SharedSetUp& setUp, std::int64_t scansBefore, const TableStand& stands,
                               const Progress& progress) {
  std::unique_lock alone(inUse_, std::defer_lock);
  while (!alone.try_lock_for(kSlice)) progress.checkpoint(0.0);
  Use use(*this, std::move(alone));
  const auto* real = std::get_if<RealDevices>(&*setUp->devices);
  if (real == nullptr) {
    use.rig_ = factory_.open(*setUp->devices, scansBefore, progress);
    return use;
  }
  if (!keeps(*setUp) || rig_->sensor->notReady() || rig_->positioner->notReady()) {
    rig_.reset();
    RealDevices devices = *real;
    devices.stands = stands;
    rig_ = factory_.open(devices, scansBefore, progress);
    of_ = setUp;
  }
  use.rig_ = *rig_;
  return use;
}

std::optional<RigKeeper::Use> RigKeeper::lookAt(const SharedSetUp& setUp) {
  std::unique_lock alone(inUse_, std::try_to_lock);
  if (!alone || !setUp || !keeps(*setUp)) return std::nullopt;
  Use use(*this, std::move(alone));
  use.rig_ = *rig_;
  return use;
}

}  // namespace vantage
