#pragma once

#include <span>
#include <vector>

#include "void_space/void_patch.h"

namespace vantage {

struct VoidExtentOptions {
  double reach = 1.0;                  ///< width of the strip that a view shows behind an open patch [mm]
  double farthest = 1.0;               ///< patches that face each other across no more than this bound one hole [mm]
  double facingAngle = radians(60.0);  ///< patches face each other when either lies this near to where the other points
};

/// How much unseen surface stands behind each void patch, as a multiple of what stands behind an open one, > 0.
///
/// Where another patch faces a patch across the void the two bound a hole and share the surface in it: a patch stands
/// for a strip half as wide as the distance to the nearest patch that faces it. A slit between two scans so attracts
/// less than an open limb, a wide hole more, and all patches around a hole together promise its area. A patch that no
/// other faces is open: behind a limb the surface curves away, and a view sees no more than a strip of `reach`.
/// @throws InvalidInput unless reach and farthest are positive.
[[nodiscard]] std::vector<double> voidExtents(std::span<const VoidPatch> patches, const VoidExtentOptions& options);

}  // namespace vantage
