#pragma once

#include "geometry/vectors.h"

namespace vantage {

/// The local frame of a boundary edge e with triangle e_T (Pito 1999, 4.3.1, Fig. 9a): x along e, n the outer normal,
/// z = x cross n, with the sense of x chosen so that z points from e into e_T. Right-handed in the order (x, n, z).
///
/// Angles turn in the plane of z and n: 0 along z (the triangle itself), pi/2 along n, pi the flat continuation of e_T
/// beyond the edge, 2 pi back at the triangle from behind.
struct EdgeFrame {
  Vec3 middle = Vec3::Zero();  ///< of e
  Vec3 x = Vec3::UnitX();      ///< unit, from `to` toward `from`
  Vec3 n = Vec3::UnitY();      ///< unit, perpendicular to e
  Vec3 z = Vec3::UnitZ();      ///< unit, into e_T
  double length = 0.0;         ///< of e [mm]

  [[nodiscard]] Vec3 from() const { return middle + 0.5 * length * x; }
  [[nodiscard]] Vec3 to() const { return middle - 0.5 * length * x; }

  /// Angle in [0, 2 pi) of a direction, seen along e; 0 for a direction along e.
  [[nodiscard]] double angleOf(const Vec3& direction) const;

  /// The unit direction at an angle.
  [[nodiscard]] Vec3 direction(double angle) const;

  /// Share of a unit direction that is perpendicular to e: the sine of its angle to e.
  [[nodiscard]] double across(const Vec3& direction) const;
};

/// The frame of an edge directed as in its triangle: e_T lies to the left of from -> to seen from outside.
/// @param normal outer normal of the surface at the edge, any length; its part along e is dropped.
/// @throws InvalidInput when the edge has no length or the normal lies along it.
[[nodiscard]] EdgeFrame makeEdgeFrame(const Vec3& from, const Vec3& to, const Vec3& normal);

}  // namespace vantage
