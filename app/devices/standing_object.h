#pragma once

#include "acquisition/acquisition_state.h"
#include "devices/device_factory.h"

namespace vantage {

/// The devices with what stands before them now: a simulated object has been turned over as the state says, see
/// simulatedStand. Real ones are what they are.
[[nodiscard]] DeviceSetUp withObjectAsItStands(DeviceSetUp devices, const AcquisitionState& state);

}  // namespace vantage
