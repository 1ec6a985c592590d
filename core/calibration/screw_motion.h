#pragma once

#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Turns of an object about one axis, as a scanner that stays sees them.
struct ScrewMotion {
  Vec3 point = Vec3::Zero();       ///< on the axis, scanner coordinates [mm]
  Vec3 direction = Vec3::UnitZ();  ///< unit
  std::vector<double> angles;  ///< how far the object had turned about `direction` in each scan, 0 in the first [rad]

  /// T_object_scanner of a scan: the object's frame is the scanner's in the first scan.
  [[nodiscard]] Pose pose(std::size_t scan) const;
  [[nodiscard]] std::vector<Pose> poses() const;
  /// The point of the axis that is nearest to p.
  [[nodiscard]] Vec3 nearestTo(const Vec3& p) const { return point + (p - point).dot(direction) * direction; }
};

/// Two unit vectors that make a right-handed frame with a direction.
struct AcrossAxis {
  Vec3 first;
  Vec3 second;
  explicit AcrossAxis(const Vec3& direction);
};

}  // namespace vantage
