#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.h"
#include "registration/icp.h"
#include "registration/multi_view.h"

namespace vantage {

/// How many points a registration against all placed views looks up.
struct AlignmentSampling {
  std::size_t pointsPerView = 8000;  ///< of every placed view that the next one is registered against
  std::size_t finePoints = 15000;    ///< in the place of IcpOptions::finePoints: the refinement follows
};

struct AlignmentOptions {
  IcpOptions icp;               ///< of every single view; a prior in it counts for all of them
  MultiViewOptions refinement;  ///< of the views that found their place
  AlignmentSampling sampling;
};

/// How one view found its place.
struct ViewAlignment {
  Verdict verdict = Verdict::Failed;
  Finding finding;
  double rms = 0.0;          ///< [mm]
  double inlierShare = 0.0;  ///< 0..1
};

struct AlignmentResult {
  std::vector<Pose> poses;           ///< one per view; the first to the last bit as given, those that failed as well
  std::vector<ViewAlignment> views;  ///< one per view; the first is Good by definition
  std::vector<std::size_t> order;    ///< views in the order in which they were placed, the first first
  MultiViewResult refinement;        ///< of the views in `order`, sorted by index
};

/// Brings scans with rough poses together: from the first view on always the view that overlaps most with those placed
/// already is registered against their union; a view that fails waits until the others are placed. Then all placed
/// views are refined at once.
/// @throws InvalidInput as registerView and refineViews, Cancelled
[[nodiscard]] AlignmentResult registerViews(std::span<const View> views, const AlignmentOptions& options,
                                            const Progress& progress = {});

}  // namespace vantage
