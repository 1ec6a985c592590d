#include "planning/planner.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "planning/candidate_tracing.h"
#include "planning/certificate.h"
#include "planning/choice.h"
#include "planning/objective.h"
#include "planning/planning_surface.h"

namespace vantage {
namespace {

ChoiceOptions rulesOf(const PlanningScene& scene) {
  const PlannerOptions& options = scene.options();
  const double spacing = scene.spacing();
  const double modelArea = area(scene.input().model->mesh);
  const double perView = modelArea / static_cast<double>(scene.input().views.size());
  ChoiceOptions rules;
  rules.leastOverlap = options.leastOverlap.value_or(
      std::max(options.overlapShare * perView, options.overlapSamples * spacing * spacing));
  TerminationOptions termination = options.termination;
  if (scene.expected() != nullptr) termination.share = std::max(termination.share, options.forecastShare);
  rules.terminationThreshold = terminationThreshold(termination, spacing, modelArea);
  rules.maxPoseSigma = options.poseSigmaShare * spacing;
  rules.maxRelaxations = options.maxRelaxations;
  rules.preferOverlap = scene.spread().isWide();
  if (options.tableAloneShare < 1.0 && !scene.spread().isWide())
    rules.tableAloneThreshold = std::max(rules.terminationThreshold, options.tableAloneShare * modelArea);
  return rules;
}

std::vector<PositionScore> scoresOf(const PlanningScene& scene, const std::vector<double>& voidAreas,
                                    const std::vector<double>& overlapAreas) {
  std::vector<PositionScore> scores;
  for (std::size_t i = 0; i < voidAreas.size(); ++i) {
    PositionScore score;
    score.position = static_cast<int>(i);
    score.voidArea = scene.taken(score.position) ? 0.0 : voidAreas[i];
    score.overlapArea = overlapAreas[i];
    scores.push_back(std::move(score));
  }
  return scores;
}

// The positions not yet traced that could beat the choice, best first, a batch at a time. The first batch is filled
// up with positions that promise less: positional space may be wrong by its angular error.
std::vector<std::size_t> untracedLeaders(const std::vector<PositionScore>& scores, const Choice& choice,
                                         const ChoiceOptions& rules, int batch) {
  const double toBeat = promise(scores[static_cast<std::size_t>(choice.position.value())]);
  const bool first =
      std::none_of(scores.begin(), scores.end(), [](const auto& s) { return s.tracedVoidArea.has_value(); });
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const PositionScore& s = scores[i];
    const bool overlaps = choice.tableAlone || s.overlapArea > choice.leastOverlap;
    const bool open = !s.tracedVoidArea && overlaps && s.voidArea > rules.terminationThreshold;
    if (open && (first || s.voidArea >= toBeat)) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a].voidArea > scores[b].voidArea; });
  order.resize(std::min<std::size_t>(order.size(), static_cast<std::size_t>(std::max(1, batch))));
  return order;
}

// Judges the positions that promise most with the scanner's own rays, until the best of them is known for sure.
Choice chooseTraced(const PlanningScene& scene, std::vector<PositionScore>& scores,
                    const std::vector<SurfaceElement>& elements, const ChoiceOptions& rules, const Progress& progress) {
  const Workspace& workspace = scene.profile().workspace;
  Choice choice = choose(scores, workspace, scene.input().current, rules);
  while (choice.outcome == PlanOutcome::Found) {
    const auto next = untracedLeaders(scores, choice, rules, scene.options().tracedPositions);
    if (next.empty()) break;
    parallelChunks(next.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        traceVoid(scores[next[k]], scene);
        predictRegistration(scores[next[k]], scene, elements);
      }
    });
    choice = choose(scores, workspace, scene.input().current, rules);
  }
  return choice;
}

// Whether one more view is to find out if the prediction is right that little is left: the last one showed enough.
bool mayProbe(const PlanningScene& scene, double threshold) {
  const std::vector<ForecastEntry>& ledger = scene.input().ledger;
  return scene.expected() != nullptr && scene.options().probeShare < 1.0 && !ledger.empty() &&
         ledger.back().achieved > threshold;
}

// What all positions together would show of the expected surface, and of the patches.
SurfaceLeft surfaceLeft(const PlanningScene& scene, const PositionalImage& expected, double ofPatches) {
  const std::vector<LevelFace>& faces = scene.expected()->closing.faces;
  const ForecastTrust& trust = scene.expected()->trust;
  double predicted = ofPatches / trust.factor;
  for (std::size_t f = 0; f < expected.sourceCount(); ++f)
    if (std::any_of(expected.sightingsOf(f).begin(), expected.sightingsOf(f).end(), [&](const Sighting& sighting) {
          return scene.expectedAttracts(f, static_cast<double>(sighting.confidence));
        }))
      predicted += faces[f].area;
  constexpr double kDeviations = 2.0;
  return {trust.factor * predicted, std::max(0.0, trust.factor - kDeviations * trust.spread) * predicted,
          (trust.factor + kDeviations * trust.spread) * predicted};
}

void decide(Plan& plan, const PlanningScene& scene, const ScannerImages& images, const Mesh& overlapping,
            const Progress& progress) {
  const ChoiceOptions rules = rulesOf(scene);
  const auto elements = surfaceElements(overlapping, scene.options().overlapElements);
  Choice choice = chooseTraced(scene, plan.scores, elements, rules, progress.part(0.0, 0.6));
  if (plan.forecast && choice.outcome == PlanOutcome::Finished && mayProbe(scene, rules.terminationThreshold)) {
    ChoiceOptions probing = rules;
    probing.terminationThreshold *= scene.options().probeShare;
    choice = chooseTraced(scene, plan.scores, elements, probing, progress.part(0.6, 0.7));
    plan.forecast->probing = choice.outcome == PlanOutcome::Found;
    // What keeps positions from being chosen is F as it is.
    if (!plan.forecast->probing) choice = choose(plan.scores, scene.profile().workspace, scene.input().current, rules);
  }
  std::span<const Pose> left;
  if (choice.outcome != PlanOutcome::Found) left = scene.profile().workspace.poses;
  plan.outlook = certify(scene, left, progress.part(0.7, 0.9));
  plan.voidLeft = promiseLeft(plan.outlook);
  if (plan.forecast) {
    for (PositionScore& score : plan.scores) score.uncorrected = promise(score) / plan.forecast->trust.factor;
    if (choice.outcome != PlanOutcome::Found) {
      plan.forecast->left = surfaceLeft(scene, expectedImage(scene, images, progress.part(0.9, 1.0)), plan.voidLeft);
      plan.voidLeft = plan.forecast->left->area;
    }
  }
  plan.outcome = choice.outcome;
  plan.position = choice.position;
  plan.leastOverlap = choice.leastOverlap;
  plan.relaxations = choice.relaxations;
  plan.tableAlone = choice.tableAlone;
  plan.terminationThreshold = rules.terminationThreshold;
}

}  // namespace

Plan planNextView(const PlanInput& input, const ScannerImages& images, const PlannerOptions& options,
                  const Progress& progress) {
  const PlanningScene scene(input, options, progress.part(0.0, 0.25, "void_patches"));
  const Mesh overlapping = withoutBorder(scene.surface(), options.borderRings);
  const auto voidAreas = voidObjective(scene, images, progress.part(0.25, 0.45, "project_void"));
  const auto overlapAreas = overlapObjective(scene, surfaceElements(overlapping, options.planningTriangles), images,
                                             progress.part(0.45, 0.75, "project_seen"));
  Plan plan;
  plan.voids = scene.voids();
  plan.scores = scoresOf(scene, voidAreas, scene.spread().least(overlapAreas));
  plan.angularError = images.grid().shape().angularError;
  if (scene.expected() != nullptr) plan.forecast = PlanForecast{scene.expected()->trust, {}, false};
  decide(plan, scene, images, overlapping, progress.part(0.75, 1.0, "choose"));
  return plan;
}

}  // namespace vantage
