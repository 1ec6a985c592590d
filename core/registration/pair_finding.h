#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "registration/motion_information.h"
#include "registration/view_surface.h"

namespace vantage {

/// What became of a point that was looked up on a view's surface.
enum class PairState : std::uint8_t {
  Unseen,   ///< no surface along its ray, facing away, or hidden far behind the surface
  Border,   ///< its ray meets the rim of the view
  Behind,   ///< farther behind the surface than the gate, though near: hidden or in the wrong place
  InFront,  ///< farther in front than the gate: the scanner looked through it
  Turned,   ///< near, but the normals disagree
  Paired,
};

/// A point and its partner on a view's surface.
struct Pair {
  Vec3 point = Vec3::Zero();   ///< the partner on the view, scanner coordinates
  Vec3 normal = Vec3::Zero();  ///< mean of both normals, unit: the symmetric point-to-plane direction
  double distance = 0.0;       ///< normal . (point looked up - partner) [mm]
  double normalSpread = 0.0;   ///< squared difference of the two normals
  float weight = 0.0F;         ///< geometric mean of the confidences
  PairState state = PairState::Unseen;
};

/// Which pairs are believed.
struct PairGates {
  double distance = 0.8;         ///< farthest along the normal [mm]
  double depth = 10.0;           ///< a point farther behind the surface is hidden, not misplaced [mm]
  double angle = radians(35.0);  ///< largest between the normals
};

/// Looks up points[ids[k]] on the surface, the result goes to pairs[k]; `positions` (one per id) carries over from
/// round to round where in the grid each was found.
/// @throws Cancelled
void findPairs(const OrientedPoints& points, std::span<const std::uint32_t> ids, const Pose& T_scanner_points,
               const ViewSurface& surface, const PairGates& gates, std::span<std::optional<GridPosition>> positions,
               const Progress& progress, std::span<Pair> pairs);
void findPairs(const OrientedVertices& points, std::span<const std::uint32_t> ids, const Pose& T_scanner_points,
               const ViewSurface& surface, const PairGates& gates, std::span<std::optional<GridPosition>> positions,
               const Progress& progress, std::span<Pair> pairs);

/// Median of the |distances| of the believed pairs; 0 for none.
[[nodiscard]] double medianDistance(std::span<const Pair> pairs);

/// The robust weight of a distance r under Geman-McClure with scale c: (c^2 / (c^2 + r^2))^2.
[[nodiscard]] inline double robustWeight(double r, double c) {
  const double q = c * c / (c * c + r * r);
  return q * q;
}

}  // namespace vantage
