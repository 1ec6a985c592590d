#pragma once

#include <algorithm>

#include "geometry/measures.h"
#include "measuring/surface_plane.h"

namespace vantage {

/// A cut through what a view shows, across one of the axes of the object.
struct Section {
  int axis = 0;          ///< 0 x, 1 y, 2 z
  double at = 0.0;       ///< where on it [mm]
  bool flipped = false;  ///< what is below is taken away, not what is above

  bool operator==(const Section&) const = default;

  /// The plane; what is in front of it is taken away.
  [[nodiscard]] SurfacePlane plane() const {
    const double sign = flipped ? -1.0 : 1.0;
    return {sign * Vec3::Unit(axis), sign * at};
  }
  [[nodiscard]] bool hides(const Vec3& p) const { return plane().distance(p) > 0.0; }
  /// The same cut, kept inside of a box.
  [[nodiscard]] Section inside(const BoundingBox& box) const {
    Section kept = *this;
    kept.at = std::clamp(at, box.min[axis], box.max[axis]);
    return kept;
  }
};

}  // namespace vantage
