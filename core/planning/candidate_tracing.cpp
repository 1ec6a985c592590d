#include "planning/candidate_tracing.h"

#include "planning/patch_promise.h"

namespace vantage {

void traceVoid(PositionScore& score, const Pose& T_object_scanner, std::span<const VoidPatch> patches,
               const PatchHistory& history, const SightTest& sight, std::optional<double> breakdownAngle) {
  double sum = 0.0;
  score.patches.clear();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (history.answered(p)) continue;
    const Sight s = lookAt(sight, T_object_scanner, patches[p], breakdownAngle);
    const double promised = patchPromise(patches[p], p, history, s, breakdownAngle);
    if (promised <= 0.0) continue;
    sum += promised;
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
