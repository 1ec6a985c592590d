#include "planning/patch_promise.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// Nearer to the plane of an opening a view hardly looks through it [rad].
constexpr double kOpeningAngle = radians(85.0);

}  // namespace

double widestLook(const VoidPatch& patch, double breakdownAngle) {
  return patch.edgeClass == EdgeClass::Regular ? breakdownAngle : std::max(breakdownAngle, kOpeningAngle);
}

Sight lookAt(const SightTest& sight, const Pose& T_object_scanner, const VoidPatch& patch,
             std::optional<double> breakdownAngle) {
  if (!breakdownAngle) return sight.look(T_object_scanner, patch.centre, patch.normal);
  return sight.look(T_object_scanner, patch.centre, patch.normal, widestLook(patch, *breakdownAngle));
}

double lookAhead(const VoidPatch& patch, const Vec3& direction, double breakdownAngle) {
  const Vec3 beyond = (patch.corners[2] + patch.corners[3] - patch.corners[0] - patch.corners[1]).normalized();
  const double phi = std::asin(std::clamp(direction.dot(beyond), -1.0, 1.0));
  return std::clamp(1.0 + phi / breakdownAngle, 0.0, 2.0);
}

double patchPromise(const VoidPatch& patch, std::size_t index, const PatchHistory& history, const Sight& sight,
                    std::optional<double> breakdownAngle) {
  if (sight.visibility != Visibility::Seen || !history.attracts(index, sight.cosine)) return 0.0;
  return patch.weight * sight.cosine * (breakdownAngle ? lookAhead(patch, sight.direction, *breakdownAngle) : 1.0);
}

}  // namespace vantage
