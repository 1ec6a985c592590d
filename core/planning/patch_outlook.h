#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "planning/plan.h"
#include "planning/visibility.h"
#include "scanner/triangulation.h"

namespace vantage {

struct OutlookOptions {
  /// A view has looked at a patch when its rays fell on it this much inside the breakdown angle [rad]; at the angle
  /// itself the surface behind the patch may well be a little too steep.
  double clearOfBreakdown = radians(6.0);
  /// After so many views that looked without finding surface a patch attracts no more.
  int mostLooks = 2;
  /// A patch does not attract a view from within this angle of one that looked already [rad].
  double lookSpread = radians(20.0);
};

/// What the views taken so far say about every patch. A patch that a view should have answered and did not stays void
/// for the record and, after enough looks, stops attracting views, so that termination is certain.
class PatchHistory {
 public:
  PatchHistory(std::span<const VoidPatch> patches, std::span<const View> views, const SightTest& sight,
               double breakdownAngle, const OutlookOptions& options, const Progress& progress);

  [[nodiscard]] bool answered(std::size_t patch) const { return looks_[patch].size() >= mostLooks_; }
  [[nodiscard]] std::size_t looks(std::size_t patch) const { return looks_[patch].size(); }

  /// Whether the patch attracts a view from that direction (unit, from the patch to the light source).
  [[nodiscard]] bool attracts(std::size_t patch, const Vec3& direction) const;

 private:
  std::size_t mostLooks_;
  double minSpreadCosine_;
  std::vector<std::vector<Vec3>> looks_;  // per patch: directions from which views looked
};

/// What is known of every patch. With `positions` (all of the workspace, once nothing attracts a view any more) it is the
/// certificate of termination: why each edge is left; without them reasons stay BelowThreshold unless answered.
[[nodiscard]] std::vector<PatchOutlook> certify(std::span<const VoidPatch> patches, const PatchHistory& history,
                                                std::span<const Pose> positions, const SightTest& sight,
                                                const Progress& progress);

}  // namespace vantage
