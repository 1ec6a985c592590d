#include <algorithm>
#include <array>
#include <cmath>

#include "support/sample_objects/distance_fields.h"
#include "support/sample_objects/sample_objects.h"

namespace vantage::testing {
namespace {

// So that the bounding box of cup and handle stands on the axis.
constexpr double kHandleOverhang = 14.5;

// The middle of the wall, from the bottom's rim up.
const Vec2 kWallFoot(35.2, 4.0);
const Vec2 kWallRim(37.8, 92.8);
constexpr double kHalfWall = 2.2;

constexpr std::size_t kHandlePieces = 64;

std::array<Vec3, kHandlePieces + 1> handlePath() {
  std::array<Vec3, kHandlePieces + 1> path;
  for (std::size_t i = 0; i <= kHandlePieces; ++i) {
    const double angle = kPi * (static_cast<double>(i) / kHandlePieces - 0.5);
    // A D that is wider above than below.
    const double reach = 28.0 + 3.0 * std::sin(angle);
    path[i] = Vec3(36.5 + reach * std::cos(angle), 0.0, 49.0 + 30.0 * std::sin(angle));
  }
  return path;
}

}  // namespace

double mug(const Vec3& p) {
  static const auto kPath = handlePath();
  const Vec3 q(p.x() + kHandleOverhang, p.y(), p.z());
  const Vec2 profile(q.head<2>().norm(), q.z());
  const double bottom = segment(profile, Vec2(0.0, 3.0), Vec2(34.4, 3.0)) - 3.0;
  const double wall = segment(profile, kWallFoot, kWallRim) - kHalfWall;
  const double cup = join(bottom, wall, 5.0);
  // The handle is a strap, wider than thick, that ends in the middle of the wall.
  const Vec3 squeezed(q.x(), 0.62 * q.y(), q.z());
  const double strap = tube(squeezed, kPath, 4.2, 4.6);
  const double wallRadius =
      kWallFoot.x() + (kWallRim.x() - kWallFoot.x()) * (q.z() - kWallFoot.y()) / (kWallRim.y() - kWallFoot.y());
  // It stands flat.
  return std::max(join(cup, std::max(strap, wallRadius - profile.x()), 4.0), -q.z());
}

}  // namespace vantage::testing
