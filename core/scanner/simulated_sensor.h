#pragma once

#include <memory>
#include <optional>

#include "geometry/ray_caster.h"
#include "scanner/rig.h"
#include "scanner/simulated_table.h"

namespace vantage {

/// A sensor that looks at a mesh on a simulated table. A ranging ray yields a sample if it hits at no more than the
/// breakdown angle, inside the range limits, and at least one receiver has a free line of sight to the point (Pito
/// 1999, 4.1). Noise depends on seed, ordinal of the scan and ray only.
class SimulatedSensor final : public RangeSensor {
 public:
  /// @param object in table coordinates (z up, on the table plane z = 0).
  SimulatedSensor(std::shared_ptr<const Mesh> object, std::shared_ptr<const ScannerProfile> profile,
                  const SimulationOptions& options, std::shared_ptr<SimulatedTable> table);

  [[nodiscard]] std::string identity() const override { return "simulated sensor"; }
  void open(const Progress& progress) override;
  void close() noexcept override { object_.reset(); }
  [[nodiscard]] std::optional<std::string> notReady() const override;
  [[nodiscard]] RangeImage capture(const Progress& progress) override;

 private:
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const ScannerProfile> profile_;
  SimulationOptions options_;
  std::shared_ptr<SimulatedTable> table_;
  std::optional<RayCaster> object_;  // while it is open
};

/// A simulated sensor and the table that it looks at, not yet open. The same mesh, profile, options and scansBefore
/// give the same bytes.
[[nodiscard]] Rig simulatedRig(std::shared_ptr<const Mesh> object, const std::shared_ptr<const ScannerProfile>& profile,
                               const SimulationOptions& options, int scansBefore = 0);

}  // namespace vantage
