#pragma once

#include "base/progress.h"
#include "planning/planner.h"
#include "positional_space/positional_image.h"

namespace vantage {

/// The images in positional space that a plan was made from, rebuilt to be looked at; the planner keeps only its sums
/// over them.
struct PlanImages {
  /// P_v as the objective counts it: only what attracts views, each by its look-ahead factor. Its intersection with
  /// P_c^i is o_v(i), but for positions that a view was taken from. Keeps its sightings: sources are the void patches.
  PositionalImage voids;
  /// P_s of the surface that registration could use. Its intersection with P_c^i is o_s(i).
  PositionalImage seen;
};

/// Rebuilds the images of the plan that planNextView makes of the same input and options.
/// @param voids the void patches of that plan.
/// @throws InvalidInput when there is no view yet. @throws Cancelled
[[nodiscard]] PlanImages computePlanImages(const PlanInput& input, const VoidSurface& voids,
                                           const PlannerOptions& options, const Progress& progress);

}  // namespace vantage
