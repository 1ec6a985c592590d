#include "planning/candidate_tracing.h"

#include <algorithm>
#include <cmath>

namespace vantage {
double lookAhead(const VoidPatch& patch, const Vec3& direction, double breakdownAngle) {
  const Vec3 beyond = (patch.corners[2] + patch.corners[3] - patch.corners[0] - patch.corners[1]).normalized();
  const double phi = std::asin(std::clamp(direction.dot(beyond), -1.0, 1.0));
  return std::clamp(1.0 + phi / breakdownAngle, 0.0, 2.0);
}

void traceVoid(PositionScore& score, const Pose& T_object_scanner, std::span<const VoidPatch> patches,
               const PatchHistory& history, const SightTest& sight, std::optional<double> breakdownAngle) {
  double sum = 0.0;
  score.patches.clear();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (history.answered(p)) continue;
    const Sight s = sight.look(T_object_scanner, patches[p].centre, patches[p].normal);
    if (s.visibility != Visibility::Seen || !history.attracts(p, s.cosine)) continue;
    sum += patches[p].weight * s.cosine * (breakdownAngle ? lookAhead(patches[p], s.direction, *breakdownAngle) : 1.0);
    score.patches.push_back(static_cast<std::uint32_t>(p));
  }
  score.tracedVoidArea = sum;
}

Overlap traceOverlap(const Pose& T_object_scanner, std::span<const SurfaceElement> elements, const SightTest& sight) {
  Overlap overlap;
  for (const SurfaceElement& e : elements) {
    const Sight s = sight.look(T_object_scanner, e.centre, e.normal);
    if (s.visibility != Visibility::Seen) continue;
    overlap.points.push_back(e.centre);
    overlap.normals.push_back(e.normal);
    overlap.areas.push_back(e.area * s.cosine);
  }
  return overlap;
}

}  // namespace vantage
