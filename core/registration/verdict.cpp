#include "registration/verdict.h"

#include <array>
#include <cstdio>

namespace vantage {
namespace {

std::string number(double value, const char* format = "%.2f") {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string percent(double share) {
  return number(100.0 * share, "%.0f %%");
}

std::string motionText(const Evidence& e) {
  return "it moved " + number(e.motion, "%.1f") + " sigma away from where the mechanics put it";
}

std::string conflictText(const Evidence& e) {
  return "the scanner looked through " + percent(e.conflictShare) + " of the model's surface";
}

std::string residualText(const Evidence& e) {
  return "the surfaces differ " + number(e.residual, "%.1f") + " times as much as their noise explains";
}

std::string overlapText(const Evidence& e) {
  return "only " + percent(e.inlierShare) + " of the expected overlap fits";
}

// The finding that makes the registration a failure, or nothing.
std::string failure(const Evidence& e, const VerdictLimits& limits) {
  if (e.pairs < limits.minPairs) return "only " + std::to_string(e.pairs) + " points overlap with the model";
  if (e.inlierShare < limits.minInlierShare) return overlapText(e);
  if (e.conflictShare > limits.maxConflicts) return conflictText(e);
  if (e.residual > limits.maxResidual) return residualText(e);
  if (e.motion > limits.maxMotion) return motionText(e);
  return {};
}

std::string doubt(const Evidence& e, const VerdictLimits& limits) {
  if (e.rivalDistance > 0.0) return "a pose " + number(e.rivalDistance, "%.1f") + " mm away fits as well";
  if (e.heldByPrior > 0 || e.stability.poseSigma > limits.maxPoseSigma)
    return "the surface " + e.stability.weakName + ": that part of the pose is the mechanics' word alone";
  if (e.inlierShare < limits.lowInlierShare) return overlapText(e);
  if (e.conflictShare > limits.doubtfulConflicts) return conflictText(e);
  if (e.residual > limits.doubtfulResidual) return residualText(e);
  if (e.motion > limits.doubtfulMotion) return motionText(e);
  if (e.pairs < limits.fewPairs) return "only " + std::to_string(e.pairs) + " points overlap with the model";
  if (!e.settled) return "the pose had not come to rest when the iterations ran out";
  return {};
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

Judgement judge(const Evidence& evidence, const VerdictLimits& limits) {
  if (std::string reason = failure(evidence, limits); !reason.empty()) return {Verdict::Failed, std::move(reason)};
  if (std::string reason = doubt(evidence, limits); !reason.empty()) return {Verdict::Doubtful, std::move(reason)};
  return {Verdict::Good, percent(evidence.inlierShare) + " of the expected overlap fits"};
}

}  // namespace vantage
