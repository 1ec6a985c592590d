#include <algorithm>
#include <array>
#include <cmath>

#include "support/sample_objects/distance_fields.h"
#include "support/sample_objects/sample_objects.h"

namespace vantage::testing {
namespace {

constexpr double kAxisHeight = 23.0;
constexpr double kBack = 7.4;  // so that the bounding box stands on the axis
constexpr std::size_t kGripPieces = 48;

std::array<Vec3, kGripPieces + 1> gripPath() {
  std::array<Vec3, kGripPieces + 1> path;
  for (std::size_t i = 0; i <= kGripPieces; ++i) {
    const double t = 2.0 * static_cast<double>(i) / kGripPieces - 1.0;
    path[i] = Vec3(68.0 * t, 22.0 - 20.0 * t * t, 0.0);
  }
  return path;
}

// A round piece that faces -y, with a dish in its face; `tilt` turns it about z.
double piece(const Vec3& p, const Vec2& centre, double radius, double tilt, double dishDepth) {
  const Vec2 d = p.head<2>() - centre;
  const Vec2 local(std::cos(tilt) * d.x() + std::sin(tilt) * d.y(), -std::sin(tilt) * d.x() + std::cos(tilt) * d.y());
  // post() stands along z: lay it down so that its top is the face.
  const Vec3 lying(local.x(), p.z(), -local.y());
  const double body = post(lying, Vec3(0, 0, -10.0), radius, 26.0, 4.0);
  constexpr double kDishRadius = 34.0;
  return cut(body, sphere(lying, Vec3(0, 0, 16.0 + kDishRadius - dishDepth), kDishRadius), 2.5);
}

}  // namespace

double handset(const Vec3& p) {
  static const auto kPath = gripPath();
  const Vec3 q(p.x(), p.y() + kBack, p.z() - kAxisHeight);
  const double grip = tube(Vec3(q.x(), q.y(), 0.8 * q.z()), kPath, 11.5, 11.5);
  const double ear = piece(q, Vec2(-71.5, 0.0), 23.0, radians(6.0), 6.0);
  const double mouth = piece(q, Vec2(72.0, 0.0), 22.5, radians(-9.0), 4.5);
  return std::max(join(join(grip, ear, 9.0), mouth, 9.0), -p.z());
}

}  // namespace vantage::testing
