#pragma once

#include <vector>

#include "acquisition/stand_alignment.h"
#include "base/progress.h"
#include "composites/composite.h"
#include "composites/picked_pairs.h"

namespace vantage {

/// Three or more fix a pose; none: it is searched for. References are on the object, in its coordinates.
using PickedPairs = std::vector<PickedPair>;

/// An alignment with the poses that it gives to all views.
struct AlignedStand {
  StandAlignment alignment;
  /// T_object_scanner of the views of the object, then of those of the stand, refined together for the best
  /// possible candidate;
  /// empty where that was not done.
  std::vector<Pose> poses;
};

/// Finds how a composite lies in the object. A function of its arguments: the same ones give the same bytes.
class StandAligner {
 public:
  StandAligner() = default;
  StandAligner(const StandAligner&) = delete;
  StandAligner& operator=(const StandAligner&) = delete;
  virtual ~StandAligner() = default;

  /// @param object the stands that are known relative to each other @param stand the one that is not yet
  /// @throws InvalidInput for pairs that fix no pose; Cancelled
  [[nodiscard]] virtual AlignedStand align(const Composite& object, const Composite& stand, const PickedPairs& picks,
                                           const Progress& progress) const = 0;
};

/// The one that stands are aligned with unless another is given: alignComposites, or alignPicked with picks.
[[nodiscard]] const StandAligner& usualStandAligner();

}  // namespace vantage
