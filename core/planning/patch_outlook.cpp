#include "planning/patch_outlook.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;

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

}  // namespace vantage
