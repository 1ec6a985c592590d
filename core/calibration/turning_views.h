#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "calibration/plane_fit.h"
#include "calibration/sample_motion.h"
#include "calibration/screw_motion.h"
#include "registration/view_network.h"

namespace vantage {

/// The surface of each scan that turns with the table, ready to be registered.
class TurningViews {
 public:
  /// The samples that move and are not of the table top.
  /// @throws Cancelled
  TurningViews(std::span<const CalibrationScan> scans, std::span<const std::vector<SampleMotion>> motions,
               const std::optional<PlaneFit>& table, double breakdownAngle, const Progress& progress);

  /// The same with still samples that fit as well when they turn as `motion` says: on a surface of revolution about the
  /// axis, as the body of a mug.
  /// @param gate how far apart surfaces may lie [mm]
  /// @throws Cancelled
  [[nodiscard]] TurningViews withRound(const ScrewMotion& motion, double gate, const Progress& progress) const;

  [[nodiscard]] std::span<const PreparedView> views() const { return prepared_; }
  /// Samples of each scan.
  [[nodiscard]] const std::vector<std::size_t>& samples() const { return samples_; }
  /// Centroid of all samples, scanner coordinates [mm].
  [[nodiscard]] Vec3 centre() const;

 private:
  void prepare(const Progress& progress);

  std::vector<RangeImage> all_;      // without the table top
  std::vector<RangeImage> turning_;  // what turns of that
  double breakdownAngle_;
  std::vector<View> views_;
  std::vector<PreparedView> prepared_;
  std::vector<std::size_t> samples_;
};

}  // namespace vantage
