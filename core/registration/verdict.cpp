#include "registration/verdict.h"

#include <array>
#include <utility>

namespace vantage {
namespace {

Finding fewPairs(const Evidence& e) {
  return {VerdictReason::FewPairs, static_cast<double>(e.pairs), {}};
}

// What makes the registration a failure, if anything does.
std::optional<Finding> failure(const Evidence& e, const VerdictLimits& limits) {
  if (e.pairs < limits.minPairs) return fewPairs(e);
  if (e.inlierShare < limits.minInlierShare) return Finding{VerdictReason::FewInliers, e.inlierShare, {}};
  if (e.conflictShare > limits.maxConflicts) return Finding{VerdictReason::Conflicts, e.conflictShare, {}};
  if (e.residual > limits.maxResidual) return Finding{VerdictReason::Residual, e.residual, {}};
  if (e.motion > limits.maxMotion) return Finding{VerdictReason::Motion, e.motion, {}};
  // Where the surface does not hold the pose by itself, a doubt about the surface is one too many.
  if (e.heldByPrior > 0 && e.conflictShare > limits.heldTolerance * limits.doubtfulConflicts)
    return Finding{VerdictReason::Conflicts, e.conflictShare, {}};
  if (e.heldByPrior > 0 && e.residual > limits.heldTolerance * limits.doubtfulResidual)
    return Finding{VerdictReason::Residual, e.residual, {}};
  return std::nullopt;
}

std::optional<Finding> doubt(const Evidence& e, const VerdictLimits& limits) {
  if (e.rivalDistance > 0.0) return Finding{VerdictReason::Rival, e.rivalDistance, {}};
  if (e.heldByPrior > 0 || (limits.maxPoseSigma && e.stability.poseSigma > *limits.maxPoseSigma))
    return Finding{VerdictReason::HeldByMechanics, std::nullopt, e.stability.weakMotions};
  if (e.inlierShare < limits.lowInlierShare) return Finding{VerdictReason::FewInliers, e.inlierShare, {}};
  if (e.conflictShare > limits.doubtfulConflicts) return Finding{VerdictReason::Conflicts, e.conflictShare, {}};
  if (e.residual > limits.doubtfulResidual) return Finding{VerdictReason::Residual, e.residual, {}};
  if (e.motion > limits.doubtfulMotion) return Finding{VerdictReason::Motion, e.motion, {}};
  if (e.pairs < limits.fewPairs) return fewPairs(e);
  if (!e.settled) return Finding{VerdictReason::NotSettled, std::nullopt, {}};
  return std::nullopt;
}

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::Good:
      return "good";
    case Verdict::Doubtful:
      return "doubtful";
    case Verdict::Failed:
      break;
  }
  return "failed";
}

std::string_view name(VerdictReason reason) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastVerdictReason) + 1> kNames{
      "not_registered", "first_view",         "first_imported", "earlier_version", "inliers",       "few_inliers",
      "few_pairs",      "conflicts",          "residual",       "motion",          "rival",         "held_by_mechanics",
      "not_settled",    "contradicts_others", "no_pose_given",  "other_position",  "other_turns",   "inverse_list",
      "other_unit",     "other_frame",        "axis_beside",    "table_alone",     "held_by_all",   "table_slipped",
      "other_turn",     "taken_elsewhere",    "on_doubtful",    "held_by_few",     "table_in_doubt"};
  return kNames.at(static_cast<std::size_t>(reason));
}

Judgement judge(const Evidence& evidence, const VerdictLimits& limits) {
  if (auto finding = failure(evidence, limits)) return {Verdict::Failed, std::move(*finding)};
  if (auto finding = doubt(evidence, limits)) return {Verdict::Doubtful, std::move(*finding)};
  return {Verdict::Good, {VerdictReason::Inliers, evidence.inlierShare, {}}};
}

}  // namespace vantage
