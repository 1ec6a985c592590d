#include "planning/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "planning/candidate_tracing.h"
#include "planning/certificate.h"
#include "planning/choice.h"
#include "planning/objective.h"
#include "planning/plan_images.h"
#include "planning/planning_surface.h"
#include "planning/termination.h"
#include "planning/void_extent.h"
#include "registration/motion_information.h"
#include "void_space/void_patch_builder.h"

namespace vantage {
namespace {

// Surface elements that predict a registration; more do not change its weak direction.
constexpr std::size_t kOverlapElements = 2000;
// Pairs of a registration are not independent: neighbouring samples share errors. So many of them count as one.
constexpr double kPairsPerObservation = 20.0;
// Views see patches up to this angle, if only too steeply to sample them [rad].
constexpr double kGrazingAngle = radians(85.0);

double meanSpacing(std::span<const View> views) {
  double sum = 0.0;
  for (const View& view : views) sum += view.mesh->spacing;
  return sum / static_cast<double>(views.size());
}

// What a plan is made with, put together once.
class Planning {
 public:
  Planning(const PlanInput& input, const PlannerOptions& options)
      : input_(input),
        options_(options),
        spacing_(meanSpacing(input.views)),
        modelArea_(area(input.model.mesh)),
        threshold_(terminationThreshold(options.termination, spacing_, modelArea_)) {
    objective_.breakdownAngle = input.profile.breakdownAngle;
    objective_.tolerance = options.tolerance;
    objective_.lookAhead = options.lookAhead;
    objective_.surfaceOffset = 0.25 * spacing_;
    sight_.breakdownAngle = input.profile.breakdownAngle;
    sight_.offset = 0.25 * spacing_;
    sight_.margin = 0.5 * spacing_;
  }

  Plan make(const Progress& progress) {
    Plan plan;
    const Progress voidProgress = progress.part(0.0, 0.25, "void_patches");
    plan.voids = std::make_shared<const VoidSurface>(findVoid(voidProgress.part(0.0, 0.5)));
    const std::vector<VoidPatch>& patches = plan.voids->patches;
    const Mesh mesh = obstacleMesh(voidProgress.part(0.5, 0.8));
    const RayCaster obstacles(mesh);
    const SightTest sight(input_.profile, obstacles, sight_);
    const PatchHistory history = historyOf(patches, obstacles, voidProgress.part(0.8, 1.0));

    const auto voidAreas = voidObjective(patches, history, input_.model, obstacles, input_.images, objective_,
                                         progress.part(0.25, 0.45, "project_void"));
    const Mesh seen = withoutBorder(mesh);
    const auto overlapAreas = overlapObjective(surfaceElements(seen, options_.planningTriangles), obstacles,
                                               input_.images, objective_, progress.part(0.45, 0.75, "project_seen"));
    for (std::size_t i = 0; i < voidAreas.size(); ++i) {
      PositionScore score;
      score.position = static_cast<int>(i);
      score.voidArea = taken(score.position) ? 0.0 : voidAreas[i];
      score.overlapArea = overlapAreas[i];
      plan.scores.push_back(std::move(score));
    }
    decide(plan, seen, history, sight, progress.part(0.75, 1.0, "choose"));
    return plan;
  }

  PlanImages images(const VoidSurface& voids, const Progress& progress) const {
    const Mesh mesh = obstacleMesh(progress.part(0.0, 0.3));
    const RayCaster obstacles(mesh);
    const PatchHistory history = historyOf(voids.patches, obstacles, progress.part(0.3, 0.4));
    PlanImages result;
    result.voids =
        voidImage(voids.patches, history, input_.model, obstacles, input_.images, objective_, progress.part(0.4, 0.7));
    result.seen = overlapImage(surfaceElements(withoutBorder(mesh), options_.planningTriangles), obstacles,
                               input_.images, objective_, progress.part(0.7, 1.0));
    return result;
  }

 private:
  [[nodiscard]] Mesh obstacleMesh(const Progress& progress) const {
    return tracedMesh(input_.model.mesh, options_.tracedTriangles, options_.planningError, progress);
  }

  [[nodiscard]] PatchHistory historyOf(std::span<const VoidPatch> patches, const RayCaster& obstacles,
                                       const Progress& progress) const {
    SightOptions grazing = sight_;
    grazing.breakdownAngle = kGrazingAngle;
    return {
        patches,          input_.views, SightTest(input_.profile, obstacles, grazing), input_.profile.breakdownAngle,
        options_.outlook, progress};
  }

  // A second scan from the same place finds what the first one found.
  [[nodiscard]] bool taken(int position) const {
    return std::find(input_.taken.begin(), input_.taken.end(), position) != input_.taken.end();
  }

  [[nodiscard]] VoidSurface findVoid(const Progress& progress) const {
    VoidOptions voidOptions;
    voidOptions.breakdownAngle = input_.profile.breakdownAngle;
    VoidSurface surface = buildVoidPatches(input_.model, input_.views, voidOptions, progress);
    if (!options_.lookAhead) return surface;
    const auto extents =
        voidExtents(surface.patches, {options_.lookAheadReach * spacing_, options_.widestHole * spacing_});
    for (std::size_t p = 0; p < extents.size(); ++p) surface.patches[p].weight *= extents[p];
    return surface;
  }

  [[nodiscard]] ChoiceOptions rules() const {
    ChoiceOptions rules;
    const double perView = modelArea_ / static_cast<double>(input_.views.size());
    rules.leastOverlap = options_.leastOverlap.value_or(
        std::max(options_.overlapShare * perView, options_.overlapSamples * spacing_ * spacing_));
    rules.terminationThreshold = threshold_;
    rules.maxPoseSigma = options_.poseSigmaShare * spacing_;
    return rules;
  }

  [[nodiscard]] std::optional<double> lookAheadAngle() const {
    return options_.lookAhead ? std::optional(input_.profile.breakdownAngle) : std::nullopt;
  }

  // Judges the positions that promise most with the scanner's own rays, until the best of them is known for sure.
  Choice chooseTraced(Plan& plan, const Mesh& seen, const PatchHistory& history, const SightTest& sight,
                      const ChoiceOptions& choiceRules, const Progress& progress) const {
    const auto elements = surfaceElements(seen, kOverlapElements);
    Choice choice = choose(plan.scores, input_.profile.workspace, input_.current, choiceRules);
    while (choice.outcome == PlanOutcome::Found) {
      const auto next = untracedLeaders(plan.scores, choice, choiceRules);
      if (next.empty()) break;
      parallelChunks(next.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          trace(plan.scores[next[k]], plan.voids->patches, elements, history, sight);
      });
      choice = choose(plan.scores, input_.profile.workspace, input_.current, choiceRules);
    }
    return choice;
  }

  void decide(Plan& plan, const Mesh& seen, const PatchHistory& history, const SightTest& sight,
              const Progress& progress) const {
    const Choice choice = chooseTraced(plan, seen, history, sight, rules(), progress.part(0.0, 0.7));
    std::span<const Pose> left;
    if (choice.outcome != PlanOutcome::Found) left = input_.profile.workspace.poses;
    plan.outlook = certify(plan.voids->patches, history, left, sight, lookAheadAngle(), progress.part(0.7, 1.0));
    plan.voidLeft = promiseLeft(plan.outlook);
    plan.outcome = choice.outcome;
    plan.position = choice.position;
    plan.leastOverlap = choice.leastOverlap;
    plan.relaxations = choice.relaxations;
    plan.terminationThreshold = threshold_;
    plan.angularError = input_.images.grid().shape().angularError;
  }

  // The positions not yet traced that could beat the choice, best first, a batch at a time. The first batch is filled
  // up with positions that promise less: positional space may be wrong by its angular error.
  [[nodiscard]] std::vector<std::size_t> untracedLeaders(const std::vector<PositionScore>& scores, const Choice& choice,
                                                         const ChoiceOptions& choiceRules) const {
    const double toBeat = promise(scores[static_cast<std::size_t>(choice.position)]);
    const bool first =
        std::none_of(scores.begin(), scores.end(), [](const auto& s) { return s.tracedVoidArea.has_value(); });
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const PositionScore& s = scores[i];
      const bool open =
          !s.tracedVoidArea && s.overlapArea > choice.leastOverlap && s.voidArea > choiceRules.terminationThreshold;
      if (open && (first || s.voidArea >= toBeat)) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return scores[a].voidArea > scores[b].voidArea; });
    order.resize(std::min<std::size_t>(order.size(), static_cast<std::size_t>(std::max(1, options_.tracedPositions))));
    return order;
  }

  void trace(PositionScore& score, const std::vector<VoidPatch>& patches, std::span<const SurfaceElement> elements,
             const PatchHistory& history, const SightTest& sight) const {
    const Pose& pose = input_.profile.workspace.poses[static_cast<std::size_t>(score.position)];
    traceVoid(score, pose, patches, history, sight, lookAheadAngle());
    const Overlap overlap = traceOverlap(pose, elements, sight);
    std::vector<double> pairs;
    pairs.reserve(overlap.areas.size());
    for (const double a : overlap.areas) pairs.push_back(a / (spacing_ * spacing_ * kPairsPerObservation));
    StabilityOptions stability;
    stability.noiseSigma = std::max(input_.profile.noise.rangeSigma, 0.05 * spacing_);
    stability.prior = turntablePrior(input_.profile.mechanics);
    const Stability predicted = analyseStability(overlap.points, overlap.normals, pairs, stability);
    score.poseSigma = predicted.poseSigma;
    score.weakMotions = predicted.weakMotions;
  }

  const PlanInput& input_;
  const PlannerOptions& options_;
  double spacing_;
  double modelArea_;
  double threshold_;
  ObjectiveOptions objective_;
  SightOptions sight_;
};

}  // namespace

PlanImages computePlanImages(const PlanInput& input, const VoidSurface& voids, const PlannerOptions& options,
                             const Progress& progress) {
  if (input.views.empty()) throw InvalidInput("the images of a plan need at least one view");
  return Planning(input, options).images(voids, progress);
}

Plan planNextView(const PlanInput& input, const PlannerOptions& options, const Progress& progress) {
  if (input.views.empty()) throw InvalidInput("a next best view needs at least one view to go on from");
  return Planning(input, options).make(progress);
}

}  // namespace vantage
