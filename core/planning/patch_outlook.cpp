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
    case Visibility::OutOfReach: return EdgeReason::OutOfReach;
    case Visibility::TooSteep: return EdgeReason::TooSteep;
    case Visibility::LightBlocked: return EdgeReason::LightBlocked;
    case Visibility::ReceiverBlocked: return EdgeReason::ReceiverBlocked;
    case Visibility::Seen: return EdgeReason::BelowThreshold;
  }
  return EdgeReason::BelowThreshold;
}

}  // namespace

PatchHistory::PatchHistory(std::span<const VoidPatch> patches, std::span<const View> views, const SightTest& sight,
                           double breakdownAngle, const OutlookOptions& options, const Progress& progress)
    : mostLooks_(static_cast<std::size_t>(std::max(1, options.mostLooks))),
      minSpreadCosine_(std::cos(options.lookSpread)),
      looks_(patches.size()) {
  const double minCosine = std::cos(std::max(0.0, breakdownAngle - options.clearOfBreakdown));
  parallelChunks(patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      for (const View& view : views) {
        const Sight s = sight.look(view.T_object_scanner, patches[p].centre, patches[p].normal);
        if (s.visibility == Visibility::Seen && s.cosine >= minCosine) looks_[p].push_back(s.direction);
      }
    }
  });
}

bool PatchHistory::attracts(std::size_t patch, const Vec3& direction) const {
  if (answered(patch)) return false;
  return std::none_of(looks_[patch].begin(), looks_[patch].end(),
                      [&](const Vec3& look) { return look.dot(direction) > minSpreadCosine_; });
}

std::vector<PatchOutlook> certify(std::span<const VoidPatch> patches, const PatchHistory& history,
                                  std::span<const Pose> positions, const SightTest& sight, const Progress& progress) {
  std::vector<PatchOutlook> outlook(patches.size());
  parallelChunks(patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      outlook[p].looks = static_cast<std::uint8_t>(std::min<std::size_t>(history.looks(p), 255));
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
