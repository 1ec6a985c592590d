#pragma once

#include <vector>

#include "scanner/ray_grid.h"

namespace vantage {

/// Offsets of the receivers from the head of a ray: [right, up, forward] in the head's frame [mm].
using ReceiverOffsets = std::vector<Vec3>;

/// A vertical stripe of horizontal rays, the head turning about the vertical axis through `position`; rows run up the
/// stripe, columns along the sweep, the middle stripe points along -x.
struct RotatingStripe {
  Vec3 position;
  double stripeHeight;  ///< [mm], centred at position.z
  int samplesPerStripe;
  int stripes;
  double sweep;  ///< [rad]
};
[[nodiscard]] RayGrid makeRays(const RotatingStripe& scanner, const ReceiverOffsets& receivers);

/// A vertical stripe of rays along -x, the head travelling along y.
struct LinearStripe {
  Vec3 position;
  double stripeHeight;  ///< [mm], centred at position.z
  int samplesPerStripe;
  int stripes;
  double travel;  ///< [mm], centred at position.y
};
[[nodiscard]] RayGrid makeRays(const LinearStripe& scanner, const ReceiverOffsets& receivers);

/// A depth camera: rays through the centres of rows x columns pixels, up = z, row 0 on top.
struct Pinhole {
  Vec3 position;
  Vec3 lookAt;
  int rows;
  int columns;
  double horizontalFov;  ///< [rad]
  double verticalFov;    ///< [rad]
};
[[nodiscard]] RayGrid makeRays(const Pinhole& scanner, const ReceiverOffsets& receivers);

}  // namespace vantage
