#include "planning/patch_promise.h"

#include <algorithm>
#include <cmath>

namespace vantage {

double widestAngle(const PlanningScene& scene, const VoidPatch& patch) {
  const bool opening = scene.options().lookAhead && patch.edgeClass != EdgeClass::Regular;
  return opening ? std::max(scene.breakdownAngle(), scene.options().openingAngle) : scene.breakdownAngle();
}

Sight sightOf(const PlanningScene& scene, const Pose& T_table_scanner, std::size_t patch) {
  const VoidPatch& p = scene.patches()[patch];
  return scene.sight().look(T_table_scanner, p.centre, p.normal, widestAngle(scene, p));
}

double lookAhead(const VoidPatch& patch, const Vec3& direction, double breakdownAngle) {
  const Vec3 beyond = (patch.corners[2] + patch.corners[3] - patch.corners[0] - patch.corners[1]).normalized();
  const double phi = std::asin(std::clamp(direction.dot(beyond), -1.0, 1.0));
  return std::clamp(1.0 + phi / breakdownAngle, 0.0, 2.0);
}

double patchShare(const PlanningScene& scene) {
  const ExpectedSurface* expected = scene.expected();
  return expected == nullptr ? 1.0 : expected->trust.factor * scene.options().patchShare;
}

double patchPromise(const PlanningScene& scene, std::size_t patch, const Sight& sight) {
  if (sight.visibility != Visibility::Seen || !scene.history().attracts(patch, sight.cosine)) return 0.0;
  const VoidPatch& p = scene.patches()[patch];
  return patchShare(scene) * p.weight * sight.cosine *
         (scene.options().lookAhead ? lookAhead(p, sight.direction, scene.breakdownAngle()) : 1.0);
}

}  // namespace vantage
