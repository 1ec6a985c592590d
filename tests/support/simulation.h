#pragma once

#include <memory>
#include <utility>

#include "scanner/simulated_sensor.h"

namespace vantage::testing {

/// A simulated rig before an object, open.
[[nodiscard]] inline Rig simulation(Mesh object, const std::shared_ptr<const ScannerProfile>& profile,
                                    const SimulationOptions& options = {}, int scansBefore = 0) {
  return opened(simulatedRig(std::make_shared<const Mesh>(std::move(object)), profile, options, scansBefore));
}

}  // namespace vantage::testing
