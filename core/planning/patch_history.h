#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "scanner/sight.h"
#include "scanner/view.h"
#include "void_space/void_patch.h"

namespace vantage {

struct PatchHistoryOptions {
  /// A view has looked at a patch when its rays fell on it this much inside the breakdown angle [rad]; at the angle
  /// itself the surface behind the patch may well be a little too steep.
  double clearOfBreakdown = radians(6.0);
  /// After so many views that looked without finding surface a patch attracts no more.
  int mostLooks = 2;
  /// A patch attracts only views that see it at a cosine larger by this than any view taken so far did.
  double cosineGain = 0.07;
  /// Views count as having seen a patch up to this angle, if only too steeply to sample it [rad].
  double grazingAngle = radians(85.0);
};

/// What the views taken so far say about every patch. What one view did not find at a patch, another that sees it no
/// more squarely will not find either: at a rim that is too steep for every position the patches of one view would
/// otherwise attract all others. The view whose line of sight bounds a patch has not looked at it. A patch that views
/// should have answered and did not stays void for the record and attracts no more, so that termination is certain.
class PatchHistory {
 public:
  /// @param views in the frame of the patches and of what blocks the sight.
  /// @param dismissed 1 for patches that attract no view whatever was seen of them; none: all may
  PatchHistory(std::span<const VoidPatch> patches, std::span<const View> views, const SightTest& sight,
               const PatchHistoryOptions& options, const Progress& progress,
               std::span<const std::uint8_t> dismissed = {});

  [[nodiscard]] bool answered(std::size_t patch) const { return dismissed_[patch] != 0 || looks_[patch] >= mostLooks_; }
  [[nodiscard]] int looks(std::size_t patch) const { return looks_[patch]; }

  /// Whether the patch attracts a view that sees it at that cosine between its normal and the ray.
  [[nodiscard]] bool attracts(std::size_t patch, double cosine) const {
    return !answered(patch) && cosine > bestCosine_[patch] + cosineGain_;
  }

 private:
  int mostLooks_;
  double cosineGain_;
  std::vector<int> looks_;          // per patch: views that looked
  std::vector<double> bestCosine_;  // per patch: the most squarely that any view has seen it
  std::vector<std::uint8_t> dismissed_;
};

}  // namespace vantage
