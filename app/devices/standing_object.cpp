#include "devices/standing_object.h"

#include <memory>

#include "scanner/simulated_stand.h"

namespace vantage {

DeviceSetUp withObjectAsItStands(DeviceSetUp devices, const AcquisitionState& state) {
  auto* simulated = std::get_if<Simulated>(&devices);
  if (simulated == nullptr || state.stand() == 0) return devices;
  const Pose T_table_object =
      simulatedStand(*simulated->object, state.stands.back().down, state.stand(), simulated->options.seed);
  simulated->object = std::make_shared<const Mesh>(transformed(*simulated->object, T_table_object));
  return devices;
}

}  // namespace vantage
