#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "geometry/vectors.h"

namespace vantage {

/// A plane through points: normal . x + offset = 0.
struct PlaneFit {
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double offset = 0.0;          ///< [mm]
  Vec3 centre = Vec3::Zero();   ///< of the points that lie on it [mm]
  double extent = 0.0;          ///< root mean square of their distances from it along the shorter side [mm]
  double rms = 0.0;             ///< of their distances from the plane [mm]
  std::size_t count = 0;        ///< how many lie on it

  [[nodiscard]] double distance(const Vec3& p) const { return normal.dot(p) + offset; }
};

/// The plane that most points lie on, of those that lean no more than `mostLean` [rad] from `normal`, by least squares
/// over these points. Deterministic.
/// @param tolerance how far from the plane a point may lie [mm]
/// @return nothing when no three points span such a plane
[[nodiscard]] std::optional<PlaneFit> fitPlane(std::span<const Vec3> points, const Vec3& normal, double mostLean,
                                               double tolerance);

}  // namespace vantage
