#include "devices/standing_object.h"

#include <memory>
#include <optional>
#include <vector>

#include "scanner/simulated_stand.h"

namespace vantage {

namespace {

// T_table_object of a simulated object in a stand: the sides that it was put on were told in the coordinates of tables
// that it stood on before.
Pose simulatedPose(const Simulated& simulated, const std::vector<Stand>& stands, int stand) {
  if (stand == 0) return Pose::Identity();
  const Stand& of = stands[static_cast<std::size_t>(stand)];
  std::optional<Vec3> down = of.down;
  if (down) *down = simulatedPose(simulated, stands, of.reference).linear().transpose() * *down;
  return simulatedStand(*simulated.object, down, stand, simulated.options.seed);
}

}  // namespace

DeviceSetUp withObjectAsItStands(DeviceSetUp devices, const AcquisitionState& state) {
  auto* simulated = std::get_if<Simulated>(&devices);
  if (simulated == nullptr || state.stand() == 0) return devices;
  const Pose T_table_object = simulatedPose(*simulated, state.stands, state.stand());
  simulated->object = std::make_shared<const Mesh>(transformed(*simulated->object, T_table_object));
  return devices;
}

}  // namespace vantage
