#include "integration/exact_plane.h"

#include <algorithm>

namespace vantage {
namespace {

__extension__ using Wide = __int128;

// Whether an edge of s has all of t on its outer side.
bool separates(const PlanePoint (&s)[3], const PlanePoint (&t)[3]) {
  for (int k = 0; k < 3; ++k) {
    const PlanePoint& from = s[k];
    const PlanePoint& to = s[(k + 1) % 3];
    if (std::all_of(t, t + 3, [&](const PlanePoint& p) { return orientation(from, to, p) <= 0; })) return true;
  }
  return false;
}

}  // namespace

bool insideCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  struct Offset {
    std::int64_t x, y, squared;
  };
  const auto offset = [&](const PlanePoint& p) {
    const std::int64_t x = static_cast<std::int64_t>(p.x) - d.x;
    const std::int64_t y = static_cast<std::int64_t>(p.y) - d.y;
    return Offset{x, y, x * x + y * y};
  };
  const Offset u = offset(a);
  const Offset v = offset(b);
  const Offset w = offset(c);
  const auto cross = [](const Offset& p, const Offset& q) { return p.x * q.y - p.y * q.x; };
  const Wide determinant = static_cast<Wide>(u.squared) * cross(v, w) + static_cast<Wide>(v.squared) * cross(w, u) +
                           static_cast<Wide>(w.squared) * cross(u, v);
  return determinant > 0;
}

bool strictlyBetween(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  if (a.x != b.x) return (a.x < p.x) != (b.x < p.x) && p.x != a.x && p.x != b.x;
  return (a.y < p.y) != (b.y < p.y) && p.y != a.y && p.y != b.y;
}

bool trianglesOverlap(const PlanePoint (&s)[3], const PlanePoint (&t)[3]) {
  return !separates(s, t) && !separates(t, s);
}

}  // namespace vantage
