#include "planning/certificate.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::vector<PatchOutlook> certify(std::span<const VoidPatch> patches, const PatchHistory& history,
                                  std::span<const Pose> positions, const SightTest& sight,
                                  std::optional<double> breakdownAngle, const Progress& progress) {
  std::vector<PatchOutlook> outlook(patches.size());
  parallelChunks(patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      outlook[p].looks = static_cast<std::uint8_t>(std::min(history.looks(p), 255));
      outlook[p].answered = history.answered(p);
      if (outlook[p].answered) {
        outlook[p].reason = EdgeReason::Answered;
        continue;
      }
      if (positions.empty()) continue;
      Visibility best = Visibility::OutOfReach;
      for (const Pose& pose : positions) {
        const Sight s = lookAt(sight, pose, patches[p], breakdownAngle);
        best = std::max(best, s.visibility);
        outlook[p].promise = std::max(outlook[p].promise, patchPromise(patches[p], p, history, s, breakdownAngle));
      }
      outlook[p].reason = reasonFor(best, outlook[p].promise, history.looks(p));
    }
  });
  return outlook;
}

double promiseLeft(std::span<const PatchOutlook> outlook) {
  double sum = 0.0;
  for (const PatchOutlook& patch : outlook) sum += patch.promise;
  return sum;
}

}  // namespace vantage
