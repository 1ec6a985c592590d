#pragma once

#include <optional>
#include <span>
#include <vector>

#include "calibration/plane_fit.h"
#include "calibration/sample_motion.h"

namespace vantage {

/// Where the table top is looked for.
struct TablePlaneSearch {
  Vec3 normal = Vec3::UnitZ();      ///< its rough normal, to the side of the object
  double mostLean = radians(30.0);  ///< from that [rad]
  std::optional<Vec3> axisPoint;    ///< on the axis along `normal`; nothing: it is not known
  double radius = 1e9;              ///< farther from the axis is no table [mm]
};

/// The plane of the samples that do not move, with what moves on its positive side; nothing when they show none.
[[nodiscard]] std::optional<PlaneFit> findTablePlane(std::span<const CalibrationScan> scans,
                                                     std::span<const std::vector<SampleMotion>> motions,
                                                     const TablePlaneSearch& search);

/// How far from the table plane samples are of the table top [mm].
[[nodiscard]] double tableThickness(const PlaneFit& plane);

}  // namespace vantage
