#include "planning/certificate.h"

#include <algorithm>

#include "base/parallel.h"
#include "planning/patch_promise.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 16;

// The reason that goes with the farthest stage any position got to. A patch that is seen but attracts nobody is one
// that views saw as squarely before: in vain, or always too steeply.
EdgeReason reasonFor(Visibility best, double promise, int looks) {
  switch (best) {
    case Visibility::OutOfReach:
      return EdgeReason::OutOfReach;
    case Visibility::TooSteep:
      return EdgeReason::TooSteep;
    case Visibility::LightBlocked:
      return EdgeReason::LightBlocked;
    case Visibility::ReceiverBlocked:
      return EdgeReason::ReceiverBlocked;
    case Visibility::Seen:
      break;
  }
  if (promise > 0.0) return EdgeReason::BelowThreshold;
  return looks > 0 ? EdgeReason::Answered : EdgeReason::TooSteep;
}

PatchOutlook outlookOf(const PlanningScene& scene, std::size_t patch, std::span<const Pose> positions) {
  const int looks = scene.history().looks(patch);
  PatchOutlook outlook;
  outlook.looks = static_cast<std::uint8_t>(std::min(looks, 255));
  outlook.answered = scene.history().answered(patch);
  if (outlook.answered) outlook.reason = scene.erased(patch) ? EdgeReason::Erased : EdgeReason::Answered;
  if (outlook.answered || positions.empty()) return outlook;
  Visibility best = Visibility::OutOfReach;
  for (const Pose& pose : positions) {
    const Sight s = sightOf(scene, pose, patch);
    best = std::max(best, s.visibility);
    outlook.promise = std::max(outlook.promise, patchPromise(scene, patch, s));
  }
  outlook.reason = reasonFor(best, outlook.promise, looks);
  return outlook;
}

}  // namespace

std::vector<PatchOutlook> certify(const PlanningScene& scene, std::span<const Pose> positions,
                                  const Progress& progress) {
  std::vector<PatchOutlook> outlook(scene.patches().size());
  parallelChunks(outlook.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) outlook[p] = outlookOf(scene, p, positions);
  });
  return outlook;
}

double promiseLeft(std::span<const PatchOutlook> outlook) {
  double sum = 0.0;
  for (const PatchOutlook& patch : outlook) sum += patch.promise;
  return sum;
}

}  // namespace vantage
