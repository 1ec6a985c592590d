#include "planning/explanation.h"

#include <algorithm>

#include "base/errors.h"
#include "planning/choice.h"

namespace vantage {
namespace {

int rankOf(const Plan& plan, const PositionScore& score) {
  const auto before = std::count_if(plan.scores.begin(), plan.scores.end(), [&](const PositionScore& other) {
    return promise(other) > promise(score) || (promise(other) == promise(score) && other.position < score.position);
  });
  return static_cast<int>(before) + 1;
}

void addPatches(Explanation& why, const Plan& plan, const PositionScore& score) {
  why.patches = score.patches.size();
  if (!plan.voids) return;
  for (const std::uint32_t p : score.patches) {
    const VoidPatch& patch = plan.voids->patches.at(p);
    why.patchArea += patch.weight;
    ++why.patchesByClass[static_cast<std::size_t>(patch.edgeClass)];
  }
}

}  // namespace

std::optional<int> runnerUp(const Plan& plan) {
  const PositionScore* best = nullptr;
  for (const PositionScore& score : plan.scores)
    if (score.constraint == Constraint::Outscored && (best == nullptr || promise(score) > promise(*best)))
      best = &score;
  return best == nullptr ? std::nullopt : std::optional(best->position);
}

Explanation explain(const Plan& plan, int position) {
  if (position < 0 || position >= static_cast<int>(plan.scores.size()))
    throw InvalidInput("there is no position " + std::to_string(position) + " in the plan, expected 0 to " +
                       std::to_string(static_cast<int>(plan.scores.size()) - 1));
  const PositionScore& score = plan.scores[static_cast<std::size_t>(position)];
  Explanation why;
  why.position = position;
  why.constraint = score.constraint;
  why.shortBy = score.shortBy;
  why.voidArea = score.voidArea;
  why.tracedVoidArea = score.tracedVoidArea;
  why.promise = promise(score);
  why.overlapArea = score.overlapArea;
  why.leastOverlap = plan.leastOverlap;
  why.tableAlone = plan.tableAlone;
  why.terminationThreshold = plan.terminationThreshold;
  why.forecast = plan.forecast;
  why.poseSigma = score.poseSigma;
  why.weakMotions = score.weakMotions;
  addPatches(why, plan, score);
  why.rank = rankOf(plan, score);
  why.rival = position == plan.position ? runnerUp(plan) : plan.position;
  if (why.rival) {
    const PositionScore& rival = plan.scores[static_cast<std::size_t>(*why.rival)];
    why.rivalPromise = promise(rival);
    why.rivalOverlap = rival.overlapArea;
  }
  return why;
}

}  // namespace vantage
