#pragma once

#include "base/progress.h"
#include "composites/alignment_limits.h"
#include "composites/composite_model.h"

namespace vantage {

/// What speaks for and against a pose of two composites. Shares are of the points of both, which are spread by area,
/// 0..1.
struct PoseEvidence {
  double overlap = 0.0;  ///< lies on the other's surface, facing the same way
  double rms = 0.0;      ///< distance of that along the normals [mm]
  /// Off the other's surface where a ray of the other passed: it and its eight neighbours measured farther away.
  double conflict = 0.0;
  double table = 0.0;  ///< below a table of the other
  /// Off the other's surface though a scan of the other should have seen it: it faces the ray and nothing is in the way
  /// of ray and receiver, but neither the ray nor its eight neighbours measured anything. Ranks poses, and refuses
  /// only in plenty: scanners miss what is dark.
  double missing = 0.0;

  [[nodiscard]] double contradiction() const { return conflict + table; }
};

/// Asks the rays of both composites, with their fine points. Deterministic for any thread count. @throws Cancelled
[[nodiscard]] PoseEvidence evidenceOf(const CompositeModel& reference, const CompositeModel& moved,
                                      const Pose& T_reference_moved, const AlignmentLimits& limits,
                                      const Progress& progress = {});

}  // namespace vantage
