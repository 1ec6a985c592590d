#include "composites/alignment_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vantage {
namespace {

// What noise and spacing of the samples let the residual of a right pose be.
double residualLimit(const AlignmentLimits& limits) {
  return 2.0 * limits.scale.noise + 0.1 * limits.scale.spacing;
}

bool isRival(const AlignedPose& pose, const AlignedPose& best, const AlignmentLimits& limits,
             const AlignmentVerdictLimits& verdictLimits) {
  const double slack = verdictLimits.rivalSlack * limits.scale.noise;
  return pose.evidence.rms < verdictLimits.rivalResidual * best.evidence.rms + slack &&
         pose.score > verdictLimits.rivalScore * best.score;
}

AlignmentJudgement failure(const AlignedPose& best, const AlignmentLimits& limits,
                           const AlignmentVerdictLimits& verdictLimits) {
  const auto failed = [](AlignmentReason reason, double value) {
    return AlignmentJudgement{AlignmentVerdict::Failed, reason, value, {}};
  };
  const PoseEvidence& evidence = best.evidence;
  const bool bent = best.refinement && best.refinement->tension > verdictLimits.tension;
  const bool fits = evidence.rms <= residualLimit(limits);
  if (evidence.overlap < verdictLimits.overlap) return failed(AlignmentReason::TooLittleOverlap, evidence.overlap);
  if (fits) return failed(AlignmentReason::Contradiction, std::max(evidence.contradiction(), evidence.missing));
  if (bent) return failed(AlignmentReason::BentComposite, best.refinement->tension);
  return failed(AlignmentReason::OtherObject, evidence.rms);
}

}  // namespace

std::string_view name(AlignmentVerdict verdict) {
  constexpr std::array<std::string_view, 3> kNames{"good", "ambiguous", "failed"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

std::string_view name(AlignmentReason reason) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastAlignmentReason) + 1> kNames{
      "one_pose", "slides", "several_poses", "contradiction", "too_little_overlap", "bent_composite", "other_object"};
  return kNames.at(static_cast<std::size_t>(reason));
}

bool isPossible(const AlignedPose& pose, const AlignmentLimits& limits, const AlignmentVerdictLimits& verdictLimits) {
  const PoseEvidence& evidence = pose.evidence;
  return evidence.contradiction() <= verdictLimits.contradiction && evidence.missing <= verdictLimits.missing &&
         evidence.overlap >= verdictLimits.overlap && evidence.rms <= residualLimit(limits);
}

AlignmentJudgement judgeAlignment(std::span<const AlignedPose> poses, const AlignmentLimits& limits,
                                  const AlignmentVerdictLimits& verdictLimits) {
  if (poses.empty()) return {AlignmentVerdict::Failed, AlignmentReason::TooLittleOverlap, 0.0, {}};
  std::vector<std::size_t> choice;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (!isPossible(poses[k], limits, verdictLimits)) continue;
    if (choice.empty() || isRival(poses[k], poses[choice.front()], limits, verdictLimits)) choice.push_back(k);
  }
  if (choice.empty()) return failure(poses.front(), limits, verdictLimits);
  const AlignedPose& best = poses[choice.front()];
  if (best.leastInformation < verdictLimits.leastInformation)
    return {AlignmentVerdict::Ambiguous, AlignmentReason::Slides, best.leastInformation, std::move(choice)};
  if (choice.size() > 1) {
    const auto count = static_cast<double>(choice.size());
    return {AlignmentVerdict::Ambiguous, AlignmentReason::SeveralPoses, count, std::move(choice)};
  }
  return {AlignmentVerdict::Good, AlignmentReason::OnePose, best.evidence.overlap, std::move(choice)};
}

}  // namespace vantage
