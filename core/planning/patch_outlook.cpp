#include "planning/patch_outlook.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;

// The reason that goes with the farthest stage any position got to.
EdgeReason reasonFor(Visibility best) {
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
      return EdgeReason::BelowThreshold;
  }
  return EdgeReason::BelowThreshold;
}

}  // namespace

PatchHistory::PatchHistory(std::span<const VoidPatch> patches, std::span<const View> views, const SightTest& sight,
                           double breakdownAngle, const OutlookOptions& options, const Progress& progress)
    : mostLooks_(std::max(1, options.mostLooks)),
      cosineGain_(options.cosineGain),
      looks_(patches.size(), 0),
      bestCosine_(patches.size(), 0.0) {
  const double minCosine = std::cos(std::max(0.0, breakdownAngle - options.clearOfBreakdown));
  parallelChunks(patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      for (const View& view : views) {
        const Sight s = sight.look(view.T_object_scanner, patches[p].centre, patches[p].normal);
        if (s.visibility != Visibility::Seen) continue;
        bestCosine_[p] = std::max(bestCosine_[p], s.cosine);
        looks_[p] += s.cosine >= minCosine;
      }
    }
  });
}

std::vector<PatchOutlook> certify(std::span<const VoidPatch> patches, const PatchHistory& history,
                                  std::span<const Pose> positions, const SightTest& sight, const Progress& progress) {
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
        best = std::max(best, sight.look(pose, patches[p].centre, patches[p].normal).visibility);
        if (best == Visibility::Seen) break;
      }
      outlook[p].reason = reasonFor(best);
      if (best == Visibility::Seen && history.looks(p) > 0) outlook[p].reason = EdgeReason::Answered;
    }
  });
  return outlook;
}

}  // namespace vantage
