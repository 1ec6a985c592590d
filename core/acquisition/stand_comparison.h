#pragma once

#include "acquisition/acquisition_state.h"
#include "base/progress.h"
#include "composites/alignment_limits.h"
#include "composites/composite_model.h"
#include "composites/pose_places.h"

namespace vantage {

/// The object and the composite of a stand beside each other, ready to be looked at in any pose. Immutable.
struct StandComparison {
  int stand = 0;
  CompositeModel object;
  CompositeModel composite;  ///< of the stand, in the frame of its table
  AlignmentLimits limits;    ///< of both

  /// Where both lie on each other at a pose, and what speaks against it: reference is the object. @throws Cancelled
  [[nodiscard]] PosePlaces placesAt(const Pose& T_object_stand, const Progress& progress = {}) const;
};

/// Some seconds of work for large scans.
/// @throws InvalidInput for a stand that may not be aligned (see AlignStand); Cancelled
[[nodiscard]] StandComparison compareStand(const AcquisitionState& state, int stand, const Progress& progress = {});

}  // namespace vantage
