#pragma once

#include <array>
#include <span>

#include "geometry/vectors.h"

namespace vantage {

/// A circle in space.
struct Circle {
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, of its plane
  double radius = 0.0;          ///< [mm]
  double rms = 0.0;             ///< of the points' distances from it [mm]; 0 through three points

  [[nodiscard]] double diameter() const { return 2.0 * radius; }
};

/// The circle through three points. @throws InvalidInput when they are on one line or not finite
[[nodiscard]] Circle circleThrough(const std::array<Vec3, 3>& points);

/// The circle in the plane of some points, for example of a section, to which they are nearest: the sum of the squares
/// of their distances is least (Gauss-Newton from the algebraic fit of Kasa 1976).
/// @throws InvalidInput for fewer than three points, points on one line, or ones that are not finite
[[nodiscard]] Circle circleFit(std::span<const Vec3> points);

/// A cylinder without ends.
struct Cylinder {
  Vec3 point = Vec3::Zero();  ///< of its axis, amid the points
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double radius = 0.0;        ///< [mm]
  double rms = 0.0;           ///< of the points' distances from it [mm]

  [[nodiscard]] double diameter() const { return 2.0 * radius; }
};

/// The cylinder to which points of a surface are nearest, from a first guess of its axis: the direction that their
/// normals are across from.
/// @param normals unit, one per point
/// @throws InvalidInput for fewer than six points, normals that tell no axis, or ones that are not finite
[[nodiscard]] Cylinder cylinderFit(std::span<const Vec3> points, std::span<const Vec3> normals);

}  // namespace vantage
