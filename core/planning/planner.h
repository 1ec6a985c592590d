#pragma once

#include <optional>
#include <span>

#include "base/progress.h"
#include "integration/model.h"
#include "planning/patch_outlook.h"
#include "planning/plan.h"
#include "planning/termination.h"
#include "positional_space/scanner_images.h"
#include "registration/pose_prior.h"
#include "scanner/profile.h"
#include "scanner/view.h"

namespace vantage {

struct PlannerOptions {
  /// u: triangles sampled with less confidence attract views that would sample them with at least u (Appendix). 0: off.
  double tolerance = 0.0;
  /// t, least confidence-weighted overlap away from the model's border [mm^2]; unset: `overlapShare` of the model's
  /// area per view taken, but no less than the area of `overlapSamples` samples.
  std::optional<double> leastOverlap;
  double overlapShare = 0.1;
  double overlapSamples = 300.0;
  /// The overlap must fix the pose to within this share of the sample spacing.
  double poseSigmaShare = 0.2;
  /// Void patches look ahead to the surface behind them. Off: the objective of the paper.
  bool lookAhead = true;
  /// So far ahead an open void patch stands for unseen surface, and patches that face each other across no more than
  /// this bound one hole [sample spacings].
  double lookAheadReach = 3.0;
  double widestHole = 16.0;
  /// Positions that positional space ranks highest are judged with the scanner's own rays, this many at a time.
  int tracedPositions = 16;
  /// Triangles that stand for the model's surface when it is projected into positional space.
  std::size_t planningTriangles = 30000;
  /// A model of more triangles than this is decimated before rays are traced through it, by no more than the error
  /// [mm].
  std::size_t tracedTriangles = 300000;
  double planningError = 0.1;
  OutlookOptions outlook;
  TerminationOptions termination;
};

/// What a plan is made from. References must outlive the call.
struct PlanInput {
  const ScannerProfile& profile;
  const ScannerImages& images;
  const Model& model;
  std::span<const View> views;
  int current = -1;                 ///< position of the last scan, -1 for none
  std::span<const int> taken = {};  ///< positions that were scanned from with the object as it stands now
};

/// Finds the next best view (Pito 1999, 5.3): void patches on the model's boundary and the model's triangles are
/// projected into positional space, every position of the workspace is scored by intersecting its image with theirs,
/// and the positions that promise most are judged again with the scanner's own rays. Steps reported: void_patches,
/// project_void, project_seen, choose.
/// @throws InvalidInput when there is no view yet. @throws Cancelled
[[nodiscard]] Plan planNextView(const PlanInput& input, const PlannerOptions& options, const Progress& progress);

}  // namespace vantage
