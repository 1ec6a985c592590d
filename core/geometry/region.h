#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

// Regions of space, as values: all in one frame, which their owner names.

/// What lies below a plane, on the side that its normal points away from.
struct BelowPlane {
  Vec3 point = Vec3::Zero();    ///< on the plane [mm]
  Vec3 normal = Vec3::UnitZ();  ///< unit; the region is where (p - point) . normal <= 0

  bool operator==(const BelowPlane&) const = default;
};

/// A box that may be turned.
struct OrientedBox {
  Pose T_region_box = Pose::Identity();  ///< its middle and axes
  Vec3 size = Vec3::Ones();              ///< its edges [mm]

  bool operator==(const OrientedBox& other) const {
    return T_region_box.matrix() == other.T_region_box.matrix() && size == other.size;
  }
};

/// What a polygon covers that was drawn in a picture, as far as it is deep: a lasso.
struct Prism {
  /// The eye: x to the right, y up, and it looks along -z.
  Pose T_region_eye = Pose::Identity();
  /// Whether lines of sight meet in the eye; else they are parallel to its z axis.
  bool perspective = false;
  /// Its corners, in either sense; where its lines cross themselves, what is covered an odd number of times counts. Of
  /// parallel sight x and y of the eye [mm], else tangents of the angles, x / -z and y / -z.
  std::vector<Vec2> corners;
  double nearest = 0.0;   ///< how far along -z it begins [mm]; where lines meet at least 0
  double farthest = 0.0;  ///< and where it ends [mm]; infinite: nowhere

  bool operator==(const Prism& other) const {
    return T_region_eye.matrix() == other.T_region_eye.matrix() && perspective == other.perspective &&
           corners == other.corners && nearest == other.nearest && farthest == other.farthest;
  }
};

/// What is near to one of many points: the surface that they are of, with what is on it.
struct NearPoints {
  std::vector<Vec3> points;
  double radius = 1.0;  ///< [mm]

  bool operator==(const NearPoints&) const = default;
};

using Region = std::variant<BelowPlane, OrientedBox, Prism, NearPoints>;

/// "below", "box", "lasso", "near".
[[nodiscard]] std::string_view kindOf(const Region& region);

/// @throws InvalidInput for a region that is none: no direction, no size, fewer than three corners, no points, a number
/// that is not finite (but `farthest`), a pose that is not a rigid motion, or more than 1,000,000 corners or points.
void validate(const Region& region);

/// The region in another frame, moved as a rigid body is.
[[nodiscard]] Region moved(const Region& region, const Pose& T_target_region);

}  // namespace vantage
