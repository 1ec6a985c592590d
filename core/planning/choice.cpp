#include "planning/choice.h"

#include <algorithm>

namespace vantage {
namespace {

// The first constraint that binds a position under the rules, or Outscored when none does.
Constraint bind(PositionScore& score, const ChoiceOptions& options, bool tableAlone) {
  score.shortBy = 0.0;
  if (promise(score) <= options.terminationThreshold) {
    score.shortBy = options.terminationThreshold - promise(score);
    return Constraint::BelowThreshold;
  }
  if (tableAlone && promise(score) > *options.tableAloneThreshold) return Constraint::Outscored;
  if (score.overlapArea <= options.leastOverlap) {
    score.shortBy = options.leastOverlap - score.overlapArea;
    return Constraint::OverlapShort;
  }
  if (score.poseSigma.value_or(0.0) > options.maxPoseSigma) {
    score.shortBy = *score.poseSigma - options.maxPoseSigma;
    return Constraint::PoseUncertain;
  }
  return Constraint::Outscored;
}

// Whether a beats b: more void, then less motion, then the lower index; more overlap before them, when it is scarce.
bool better(const PositionScore& a, const PositionScore& b, const Workspace& workspace, std::optional<int> current,
            bool overlapFirst) {
  if (overlapFirst && a.overlapArea != b.overlapArea) return a.overlapArea > b.overlapArea;
  if (promise(a) != promise(b)) return promise(a) > promise(b);
  if (current) {
    const double motionA = motionBetween(workspace, *current, a.position);
    const double motionB = motionBetween(workspace, *current, b.position);
    if (motionA != motionB) return motionA < motionB;
  }
  return a.position < b.position;
}

}  // namespace

double terminationThreshold(const TerminationOptions& options, double spacing, double modelArea) {
  const double worth = std::max(options.edges * spacing * spacing, options.share * modelArea);
  return options.threshold.value_or(std::min(worth, options.mostShare * modelArea));
}

Choice choose(std::vector<PositionScore>& scores, const Workspace& workspace, std::optional<int> current,
              const ChoiceOptions& options) {
  Choice choice;
  ChoiceOptions relaxed = options;
  while (true) {
    choice.leastOverlap = relaxed.leastOverlap;
    PositionScore* best = nullptr;
    bool voidLeft = false;
    const bool overlapFirst = options.preferOverlap && choice.relaxations > 0;
    for (PositionScore& score : scores) {
      score.constraint = bind(score, relaxed, choice.tableAlone);
      voidLeft = voidLeft || score.constraint != Constraint::BelowThreshold;
      if (score.constraint != Constraint::Outscored) continue;
      if (best == nullptr || better(score, *best, workspace, current, overlapFirst)) best = &score;
    }
    if (best != nullptr) {
      best->constraint = Constraint::Chosen;
      choice.outcome = PlanOutcome::Found;
      choice.position = best->position;
      return choice;
    }
    choice.outcome = voidLeft ? PlanOutcome::NoOverlap : PlanOutcome::Finished;
    if (!voidLeft) return choice;
    if (choice.relaxations < options.maxRelaxations) {
      ++choice.relaxations;
      relaxed.leastOverlap /= 2.0;
      relaxed.maxPoseSigma *= 2.0;
    } else if (options.tableAloneThreshold && !choice.tableAlone) {
      choice.tableAlone = true;
    } else {
      choice.tableAlone = false;
      return choice;
    }
  }
}

}  // namespace vantage
