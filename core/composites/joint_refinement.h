#pragma once

#include <vector>

#include "base/progress.h"
#include "composites/composite_model.h"
#include "registration/multi_view.h"

namespace vantage {

/// All views of two composites after they were refined together. Composites give in a little, as far as their ties let
/// them; a move between composites is no tie.
struct JointRefinement {
  Pose T_reference_moved = Pose::Identity();  ///< of the moved composite as a whole
  std::vector<Pose> reference;                ///< T_reference_scanner, one per view; the first to the last bit
  std::vector<Pose> moved;                    ///< T_reference_scanner, one per view
  double referenceBend = 0.0;  ///< how far its views moved against each other, RMS over their points [mm]
  double movedBend = 0.0;      ///< the same of the moved composite [mm]
  double tension = 0.0;        ///< of the most stretched tie [sigmas]; 0 without ties
};

/// @param T_reference_moved from where they are nearly right: within the coarse gate of the refinement
/// @param options whose ties and given poses are not used: the composites bring theirs
/// @throws InvalidInput as refineViews, Cancelled
[[nodiscard]] JointRefinement refineTogether(const CompositeModel& reference, const CompositeModel& moved,
                                             const Pose& T_reference_moved, const MultiViewOptions& options,
                                             const Progress& progress = {});

/// A tie of a composite after all of it was moved.
[[nodiscard]] PoseTie movedTie(const PoseTie& tie, const Pose& T_target_composite);

}  // namespace vantage
