#include "void_space/edge_frame.h"

#include <cmath>

#include "base/errors.h"

namespace vantage {

double EdgeFrame::angleOf(const Vec3& direction) const {
  const double angle = std::atan2(direction.dot(n), direction.dot(z));
  if (angle >= 0.0) return angle;
  const double turned = angle + 2.0 * kPi;
  return turned < 2.0 * kPi ? turned : 0.0;
}

Vec3 EdgeFrame::direction(double angle) const {
  return std::cos(angle) * z + std::sin(angle) * n;
}

double EdgeFrame::across(const Vec3& direction) const {
  return std::hypot(direction.dot(n), direction.dot(z));
}

EdgeFrame makeEdgeFrame(const Vec3& from, const Vec3& to, const Vec3& normal) {
  EdgeFrame frame;
  frame.middle = 0.5 * (from + to);
  frame.length = (to - from).norm();
  if (!(frame.length > 0.0)) throw InvalidInput("a boundary edge without length has no frame");
  frame.x = (from - to) / frame.length;
  const Vec3 across = normal - normal.dot(frame.x) * frame.x;
  const double size = across.norm();
  if (!(size > 1e-9 * normal.norm())) throw InvalidInput("a boundary edge needs a normal that does not lie along it");
  frame.n = across / size;
  frame.z = frame.x.cross(frame.n);
  return frame;
}

}  // namespace vantage
