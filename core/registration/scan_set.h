#pragma once

#include <optional>
#include <span>
#include <vector>

#include "registration/alignment.h"
#include "registration/placed_views.h"

namespace vantage {

/// A set of scans that was placed, refined and judged as a whole.
struct ScanSet {
  PlacedViews placement;       ///< with the refined poses, and the views that are out of the set not in its order
  MultiViewResult refinement;  ///< of the views in the order, sorted by index

  /// How much it holds together: one for every good view, half for every doubtful one.
  [[nodiscard]] double worth() const;
};

/// Places the views from the given poses and refines them; views that contradict the others leave the set, the fewest
/// that have to, and the rest is refined again; a doubtful view that all others hold firmly becomes a good one.
/// @param views and prepared, one each per view
/// @throws InvalidInput as registerView and refineViews, Cancelled
[[nodiscard]] ScanSet judgedSet(std::span<const View> views, std::span<const PreparedView> prepared,
                                std::span<const Pose> given, const AlignmentOptions& options, const Progress& progress);

/// How much the last view contradicts all others under their poses [share of points, 0..1]; nothing where it does not.
/// @param prepared one per view
/// @param isDoubtful whether its pose is: less speaks against it then
/// @param known surface in the frame of the poses: where that, or the view's own, hides a point from a scanner, it says
///        nothing that the scanner saw none there
/// @throws Cancelled
[[nodiscard]] std::optional<double> contradictionOfLast(std::span<const View> views,
                                                        std::span<const PreparedView> prepared, bool isDoubtful,
                                                        const Mesh& known, const IcpOptions& options,
                                                        const Progress& progress);

}  // namespace vantage
