#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "registration/icp.h"
#include "registration/multi_view.h"
#include "registration/pose_list.h"

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

/// How a fault of the list is said of every scan that it concerns.
[[nodiscard]] Finding findingOf(const PoseListFinding& finding);

/// How one view found its place.
struct ViewAlignment {
  Verdict verdict = Verdict::Failed;
  Finding finding;
  double rms = 0.0;          ///< [mm]
  double inlierShare = 0.0;  ///< 0..1
};

struct AlignmentResult {
  std::vector<Pose> poses;           ///< one per view; the first of the order to the last bit as it began
  std::vector<ViewAlignment> views;  ///< one per view; the first of the order is Good by definition
  std::vector<std::size_t> order;    ///< views in the order in which they were placed
  MultiViewResult refinement;        ///< of the views that were refined together, sorted by index
  /// What was wrong with the poses of all views, where mending it brought them together: then all of them are doubtful.
  std::optional<PoseListFinding> list;
};

/// Brings scans with rough poses together and judges them as a set (see judgedSet): the largest set of views that hang
/// together and do not contradict each other stays, the first view too only if it is of it. Where that is not the whole
/// set, one fault of the whole list is looked for that explains it. Without a list nothing holds what the surface lets
/// go of: what is not good has failed then.
/// @throws InvalidInput as registerView and refineViews, Cancelled
[[nodiscard]] AlignmentResult registerViews(std::span<const View> views, const AlignmentOptions& options,
                                            const Progress& progress = {});

}  // namespace vantage
