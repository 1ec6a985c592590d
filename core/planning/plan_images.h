#pragma once

#include "base/progress.h"
#include "planning/planning_scene.h"
#include "positional_space/positional_image.h"
#include "positional_space/scanner_images.h"

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

/// Rebuilds the images of the plan that planNextView makes with the same scene and images.
/// @throws Cancelled
[[nodiscard]] PlanImages computePlanImages(const PlanningScene& scene, const ScannerImages& images,
                                           const Progress& progress);

}  // namespace vantage
