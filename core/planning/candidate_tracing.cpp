#include "planning/candidate_tracing.h"

#include <algorithm>

#include "planning/patch_promise.h"
#include "registration/motion_information.h"
#include "registration/pose_prior.h"

namespace vantage {

namespace {

// Of the expected surface what a scanner at the pose would sample [mm^2].
double expectedArea(const Pose& T_table_scanner, const PlanningScene& scene, const ExpectedSurface& expected) {
  double sum = 0.0;
  for (std::size_t f = 0; f < expected.closing.faces.size(); ++f) {
    const LevelFace& face = expected.closing.faces[f];
    const Sight s = scene.sightOfExpected().look(T_table_scanner, face.centre, face.normal);
    if (s.visibility == Visibility::Seen && scene.expectedAttracts(f, s.cosine)) sum += face.area;
  }
  return sum;
}

}  // namespace

void traceVoid(PositionScore& score, const PlanningScene& scene) {
  const Pose& T_table_scanner = scene.pose(score.position);
  double sum = 0.0;
  score.patches.clear();
  for (std::size_t p = 0; p < scene.patches().size(); ++p) {
    if (scene.history().answered(p)) continue;
    const double promised = patchPromise(scene, p, sightOf(scene, T_table_scanner, p));
    if (promised <= 0.0) continue;
    sum += promised;
    score.patches.push_back(static_cast<std::uint32_t>(p));
  }
  if (const ExpectedSurface* expected = scene.expected())
    sum += expected->trust.factor * expectedArea(T_table_scanner, scene, *expected);
  score.tracedVoidArea = sum;
}

Overlap traceOverlap(const PlanningScene& scene, int position, std::span<const SurfaceElement> elements) {
  const Pose& T_table_scanner = scene.pose(position);
  Overlap overlap;
  for (const SurfaceElement& e : elements) {
    const Sight s = scene.sight().look(T_table_scanner, e.centre, e.normal);
    if (s.visibility != Visibility::Seen) continue;
    overlap.points.push_back(e.centre);
    overlap.normals.push_back(e.normal);
    overlap.areas.push_back(e.area * s.cosine);
  }
  return overlap;
}

namespace {

Stability predictedAt(int position, const PlanningScene& scene, std::span<const SurfaceElement> elements) {
  const PlannerOptions& options = scene.options();
  const double spacing = scene.spacing();
  const Overlap overlap = traceOverlap(scene, position, elements);
  std::vector<double> pairs;
  pairs.reserve(overlap.areas.size());
  for (const double a : overlap.areas) pairs.push_back(a / (spacing * spacing * options.pairsPerObservation));
  StabilityOptions stability;
  stability.noiseSigma = std::max(scene.profile().noise.rangeSigma, options.leastRangeSigma * spacing);
  stability.prior = turntablePrior(scene.mechanics());
  return analyseStability(overlap.points, overlap.normals, pairs, stability);
}

}  // namespace

void predictRegistration(PositionScore& score, const PlanningScene& scene, std::span<const SurfaceElement> elements) {
  for (const int position : scene.spread().extremes(score.position)) {
    const Stability predicted = predictedAt(position, scene, elements);
    if (score.poseSigma && *score.poseSigma >= predicted.poseSigma && position != score.position) continue;
    score.poseSigma = predicted.poseSigma;
    score.weakMotions = predicted.weakMotions;
  }
}

}  // namespace vantage
