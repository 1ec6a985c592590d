#include "composites/alignment_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vantage {
namespace {

// The most stretched of some dozens of ties, as long as they are right [sigmas].
constexpr double kUsualTension = 3.0;

// What noise and spacing of the samples let the residual of a right pose be; and where the views of one composite do
// not lie on each other better than that, those of two will not either, up to a share of the spacing.
double residualLimit(const AlignmentLimits& limits) {
  const double explained = 1.5 * limits.scale.noise + 0.05 * limits.scale.spacing;
  return std::max(explained, std::min(1.5 * limits.residual, 0.25 * limits.scale.spacing));
}

bool isRival(const AlignedPose& pose, const AlignedPose& best, const AlignmentLimits& limits,
             const AlignmentVerdictLimits& verdictLimits) {
  const double slack = verdictLimits.rivalSlack * limits.scale.noise;
  if (pose.refinement && best.refinement && pose.evidence.rms > best.evidence.rms &&
      pose.refinement->tension > std::max(best.refinement->tension, kUsualTension) + verdictLimits.rivalTension)
    return false;
  return pose.evidence.rms < verdictLimits.rivalResidual * best.evidence.rms + slack &&
         pose.score > verdictLimits.rivalScore * best.score;
}

AlignmentJudgement failure(const AlignedPose& best, const AlignmentLimits& limits,
                           const AlignmentVerdictLimits& verdictLimits) {
  const auto failed = [](AlignmentReason reason, double value) {
    return AlignmentJudgement{AlignmentVerdict::Failed, reason, value, false, {}};
  };
  const PoseEvidence& evidence = best.evidence;
  // At a pose that free space speaks against, views part whatever the composites are like.
  const bool isFree =
      evidence.contradiction() <= verdictLimits.contradiction && evidence.missing <= verdictLimits.missing;
  const bool bent = isFree && best.refinement && best.refinement->tension > verdictLimits.tension;
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
  if (poses.empty()) return {AlignmentVerdict::Failed, AlignmentReason::TooLittleOverlap, 0.0, false, {}};
  std::vector<std::size_t> choice;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (!isPossible(poses[k], limits, verdictLimits)) continue;
    if (choice.empty() || isRival(poses[k], poses[choice.front()], limits, verdictLimits)) choice.push_back(k);
  }
  if (choice.empty()) return failure(poses.front(), limits, verdictLimits);
  const AlignedPose& best = poses[choice.front()];
  AlignmentJudgement judgement;
  judgement.bent = best.refinement && best.refinement->tension > verdictLimits.tension;
  if (best.leastInformation < verdictLimits.leastInformation) {
    judgement.verdict = AlignmentVerdict::Ambiguous;
    judgement.reason = AlignmentReason::Slides;
    judgement.value = best.leastInformation;
  } else if (choice.size() > 1) {
    judgement.verdict = AlignmentVerdict::Ambiguous;
    judgement.reason = AlignmentReason::SeveralPoses;
    judgement.value = static_cast<double>(choice.size());
  } else {
    judgement.verdict = AlignmentVerdict::Good;
    judgement.reason = AlignmentReason::OnePose;
    judgement.value = best.evidence.overlap;
  }
  judgement.choice = std::move(choice);
  return judgement;
}

}  // namespace vantage
