#pragma once

#include <cstdint>
#include <memory>

#include "geometry/ray_caster.h"
#include "scanner/device.h"
#include "scanner/profile.h"

namespace vantage {

struct SimulationOptions {
  std::uint64_t seed = 1;
  bool ideal = false;  ///< no noise, no dropout, no mechanical error
};

/// A scanner that looks at a mesh. A ranging ray yields a sample if it hits at no more than the breakdown angle, inside
/// the range limits, and at least one receiver has a free line of sight to the point (Pito 1999, 4.1).
///
/// Every move of the turntable adds an error of its own (a turn about z, a shift in x and y) to those before; the first
/// scan has none. Errors and noise depend on seed, ordinal of the scan and ray only.
class SimulatedScanner final : public ScannerDevice {
 public:
  /// @param object in object coordinates (z up, on the table plane z = 0).
  /// @param scansBefore how many scans were taken before, to go on with an interrupted series.
  SimulatedScanner(const Mesh& object, std::shared_ptr<const ScannerProfile> profile, const SimulationOptions& options,
                   int scansBefore = 0);

  [[nodiscard]] RangeImage scan(int position, const Progress& progress) override;

  /// Where the scanner really is, relative to where it believes to be, for the scan of that ordinal:
  /// T_object_scanner (true) = this * workspace pose.
  [[nodiscard]] Pose mechanicalError(int ordinal) const;

 private:
  std::shared_ptr<const ScannerProfile> profile_;
  SimulationOptions options_;
  int ordinal_;
  RayCaster object_;
};

}  // namespace vantage
