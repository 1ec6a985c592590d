#include "devices/device_factory.h"

#include <utility>

#include "devices/real_rig.h"
#include "devices/turned_by_hand.h"
#include "scanner/patient_devices.h"

namespace vantage {
namespace {

// One kind of set-up each.
struct Making {
  std::int64_t scansBefore;

  Rig operator()(const Simulated& setUp) const {
    Rig rig = simulatedRig(setUp.object, setUp.profile, setUp.options, static_cast<int>(scansBefore));
    if (setUp.ask)
      rig.positioner = std::make_shared<TurnedByHand>(
          rig.positioner, std::make_shared<HandTable>(setUp.profile, setUp.ask, kTurnedByHand));
    return rig;
  }

  Rig operator()(const RealDevices& setUp) const { return realRig(setUp); }
};

}  // namespace

Rig makeDevices(const DeviceSetUp& setUp, std::int64_t scansBefore) {
  return std::visit(Making{scansBefore}, setUp);
}

DeviceFactory::DeviceFactory(std::chrono::milliseconds patience, Maker make)
    : patience_(patience), make_(std::move(make)) {}

Rig DeviceFactory::open(const DeviceSetUp& setUp, std::int64_t scansBefore, const Progress& progress) const {
  return opened(withPatience(make_(setUp, scansBefore), patience_), progress);
}

}  // namespace vantage
