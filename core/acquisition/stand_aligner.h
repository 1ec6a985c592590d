#pragma once

#include <array>
#include <optional>
#include <vector>

#include "acquisition/stand_alignment.h"
#include "base/progress.h"
#include "composites/composite.h"

namespace vantage {

/// A point that a person picked on both composites, each in its own coordinates [mm].
struct PickedPair {
  Vec3 reference = Vec3::Zero();
  Vec3 moved = Vec3::Zero();
};
/// Three or more fix a pose; none: it is searched for.
using PickedPairs = std::vector<PickedPair>;

/// An alignment with the poses that it gives to all views.
struct AlignedStand {
  StandAlignment alignment;
  /// T_object_scanner of the views of the object, then of those of the stand, refined together for the best candidate;
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

}  // namespace vantage
