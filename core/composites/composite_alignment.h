#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.h"
#include "composites/alignment_verdict.h"
#include "composites/picked_pairs.h"

namespace vantage {

/// The defaults of a refinement, with fewer points: it is done for several poses.
[[nodiscard]] MultiViewOptions refinementOfComposites();

struct CompositeAlignmentOptions {
  PoseSearchOptions search;
  MultiViewOptions refinement = refinementOfComposites();  ///< of all views, for every pose that is refined
  std::size_t refined = 4;                                 ///< poses that are refined: the best and its rivals
  AlignmentVerdictLimits limits;
};

/// How one composite lies against another, or why that is not known.
struct CompositeAlignment {
  AlignmentJudgement judgement;
  std::vector<AlignedPose> poses;  ///< all distinct ones with their evidence, the best first; may be empty
  /// Ambiguous between poses that leave the same surface, as with a body that is symmetric all over: the choice makes
  /// no difference.
  bool sameSurface = false;

  [[nodiscard]] AlignmentVerdict verdict() const { return judgement.verdict; }
};

/// Aligns a composite with another, or with the union of several (see united), without any hint: searches all turns,
/// refines the views of both together at the best pose and its rivals, and judges what free space says of them.
///
/// The reference stays; moving either composite by a rigid motion moves the result by it. Deterministic for any thread
/// count. Steps reported: search, refine, check.
/// @throws InvalidInput as refineViews, Cancelled
[[nodiscard]] CompositeAlignment alignComposites(const CompositeModel& reference, const CompositeModel& moved,
                                                 const CompositeAlignmentOptions& options = {},
                                                 const Progress& progress = {});

/// The same from a pose that is roughly known: it replaces the search, not the check. Rivals are not looked for.
[[nodiscard]] CompositeAlignment alignFrom(const CompositeModel& reference, const CompositeModel& moved,
                                           const Pose& T_reference_moved, const CompositeAlignmentOptions& options = {},
                                           const Progress& progress = {});

/// The same from three or more points that a person picked on both. @throws InvalidInput as poseOfPairs, too
[[nodiscard]] CompositeAlignment alignPicked(const CompositeModel& reference, const CompositeModel& moved,
                                             std::span<const PickedPair> pairs,
                                             const CompositeAlignmentOptions& options = {},
                                             const Progress& progress = {});

}  // namespace vantage
