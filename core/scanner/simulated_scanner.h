#pragma once

#include "scanner/simulated_sensor.h"

namespace vantage {

/// A simulated rig behind one call.
class SimulatedScanner final : public ScannerDevice {
 public:
  /// @param object in object coordinates (z up, on the table plane z = 0).
  /// @param scansBefore how many scans were taken before, to go on with an interrupted series.
  SimulatedScanner(const Mesh& object, const std::shared_ptr<const ScannerProfile>& profile,
                   const SimulationOptions& options, int scansBefore = 0)
      : rig_(opened(simulatedRig(std::make_shared<const Mesh>(object), profile, options, scansBefore))) {}

  [[nodiscard]] RangeImage scan(int position, const Progress& progress) override {
    return scanFrom(rig_, position, progress);
  }

 private:
  Rig rig_;
};

}  // namespace vantage
