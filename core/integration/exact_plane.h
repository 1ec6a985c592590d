#pragma once

#include <cstdint>

namespace vantage {

/// A point of the plane with whole coordinates, |x| and |y| <= kPlaneLimit: what follows decides about such points
/// without rounding.
struct PlanePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

inline constexpr std::int32_t kPlaneLimit = 1 << 26;

/// Twice the signed area of the triangle a, b, c: positive when it turns counter-clockwise, zero on a line.
[[nodiscard]] inline std::int64_t orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const auto sub = [](std::int32_t u, std::int32_t v) { return static_cast<std::int64_t>(u) - v; };
  return sub(b.x, a.x) * sub(c.y, a.y) - sub(b.y, a.y) * sub(c.x, a.x);
}

/// Whether d lies inside the circle through a, b, c, which turn counter-clockwise; false on the circle.
[[nodiscard]] bool insideCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);

/// Whether p lies between a and b, which are on one line with it, ends excluded.
[[nodiscard]] bool strictlyBetween(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p);

/// Whether the insides of two counter-clockwise triangles have a point in common.
[[nodiscard]] bool trianglesOverlap(const PlanePoint (&s)[3], const PlanePoint (&t)[3]);

}  // namespace vantage
