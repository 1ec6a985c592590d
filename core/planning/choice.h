#pragma once

#include <span>
#include <vector>

#include "planning/plan.h"
#include "scanner/workspace.h"

namespace vantage {

struct ChoiceOptions {
  double leastOverlap = 0.0;          ///< t [mm^2]
  double terminationThreshold = 0.0;  ///< F [mm^2]
  double maxPoseSigma = 1.0;          ///< worst predicted pose error allowed [mm]
  /// How often t may be halved, and with it the pose error doubled, when no position satisfies them.
  int maxRelaxations = 3;
};

/// The decision over all positions.
struct Choice {
  PlanOutcome outcome = PlanOutcome::Finished;
  int position = -1;
  double leastOverlap = 0.0;  ///< t as relaxed [mm^2]
  int relaxations = 0;
};

/// What a position promises: its traced void area where there is one, otherwise that of positional space [mm^2].
[[nodiscard]] inline double promise(const PositionScore& score) {
  return score.tracedVoidArea.value_or(score.voidArea);
}

/// The objective N(i) = o_v(i) if o_s(i) > t, else 0 (Pito 1999, 5.3), maximised over the positions. A tie goes to the
/// least motion from `current`, then to the lower index. When void is left above F but every such position falls short
/// of t or of a certain pose, both are relaxed up to `maxRelaxations` times and at last NoOverlap returned.
/// Writes to every score which constraint bound and by how much it was missed.
[[nodiscard]] Choice choose(std::vector<PositionScore>& scores, const Workspace& workspace, int current,
                            const ChoiceOptions& options);

}  // namespace vantage
