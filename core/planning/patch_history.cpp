#include "planning/patch_history.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;

// Whether the patch lies in the view's own line of sight to the receiver: the view saw what is on one side of it only.
bool ranAlong(const VoidPatch& patch, std::size_t view) {
  return patch.edgeClass == EdgeClass::LineOfSightJump && patch.view == view;
}

}  // namespace

PatchHistory::PatchHistory(std::span<const VoidPatch> patches, std::span<const View> views, const SightTest& sight,
                           const PatchHistoryOptions& options, const Progress& progress,
                           std::span<const std::uint8_t> dismissed)
    : mostLooks_(std::max(1, options.mostLooks)),
      cosineGain_(options.cosineGain),
      looks_(patches.size(), 0),
      bestCosine_(patches.size(), 0.0),
      dismissed_(dismissed.begin(), dismissed.end()) {
  dismissed_.resize(patches.size(), 0);
  const double minCosine = std::cos(std::max(0.0, sight.options().breakdownAngle - options.clearOfBreakdown));
  parallelChunks(patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      for (std::size_t i = 0; i < views.size(); ++i) {
        if (ranAlong(patches[p], i)) continue;
        const View& view = views[i];
        const Sight s = sight.look(view.T_object_scanner, patches[p].centre, patches[p].normal, options.grazingAngle);
        if (s.visibility != Visibility::Seen) continue;
        bestCosine_[p] = std::max(bestCosine_[p], s.cosine);
        looks_[p] += s.cosine >= minCosine;
      }
    }
  });
}

}  // namespace vantage
