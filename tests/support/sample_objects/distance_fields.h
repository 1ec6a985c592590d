#pragma once

#include <span>

#include "geometry/vectors.h"

// Building blocks of the sample objects: distances from a point to simple shapes, negative inside [mm]. Joined with the
// smooth minimum they are distances only near the surface, which is all that polygonize() needs.
namespace vantage::testing {

/// Both shapes, with a fillet about as wide as `blend`.
[[nodiscard]] double join(double a, double b, double blend = 0.0);

/// a without b, with the edge rounded over `blend`.
[[nodiscard]] double cut(double a, double b, double blend = 0.0);

[[nodiscard]] double sphere(const Vec3& p, const Vec3& centre, double radius);

/// Not an exact distance, but right at the surface.
[[nodiscard]] double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii);

/// A round bar whose radius goes evenly from one end to the other.
[[nodiscard]] double bar(const Vec3& p, const Vec3& a, const Vec3& b, double radiusA, double radiusB);

/// Bars along a polyline, tapering from the first radius to the last.
[[nodiscard]] double tube(const Vec3& p, std::span<const Vec3> path, double firstRadius, double lastRadius);

/// A flat triangle, `thickness` thick, with round rims.
[[nodiscard]] double plate(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double thickness);

/// A disc or post about the z axis through `foot`, standing on it, with its edges rounded.
[[nodiscard]] double post(const Vec3& p, const Vec3& foot, double radius, double height, double rounding);

/// A ring about the axis through `centre`; `axis` is a unit vector.
[[nodiscard]] double ring(const Vec3& p, const Vec3& centre, const Vec3& axis, double radius, double thickness);

/// Distance to a segment in the plane.
[[nodiscard]] double segment(const Vec2& p, const Vec2& a, const Vec2& b);

}  // namespace vantage::testing
