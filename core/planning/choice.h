#pragma once

#include <optional>
#include <vector>

#include "planning/plan.h"
#include "scanner/workspace.h"

namespace vantage {

struct TerminationOptions {
  /// F [mm^2]; unset: what `edges` boundary edges of one sample spacing show that are seen head-on, but no less than
  /// `share` and no more than `mostShare` of the model's area: of a model that is small, or of which little was seen,
  /// less is worth a view.
  std::optional<double> threshold;
  double edges = 17.0;
  double share = 0.0005;
  double mostShare = 0.05;
};

/// F: what a view must promise to be worth taking (Pito 1999, 5.3) [mm^2].
/// @param spacing of the samples [mm]
/// @param modelArea [mm^2]
[[nodiscard]] double terminationThreshold(const TerminationOptions& options, double spacing, double modelArea);

struct ChoiceOptions {
  double leastOverlap = 0.0;          ///< t [mm^2]
  double terminationThreshold = 0.0;  ///< F [mm^2]
  double maxPoseSigma = 1.0;          ///< worst predicted pose error allowed [mm]
  /// How often t may be halved, and with it the pose error doubled, when no position satisfies them.
  int maxRelaxations = 3;
  /// Once t had to be halved, what overlaps most is taken rather than what promises most: moves that are a guess may
  /// end where less overlaps.
  bool preferOverlap = false;
  /// At last overlap and pose error bind no more for what promises more than this: the table places the view [mm^2].
  /// Unset: never.
  std::optional<double> tableAloneThreshold = {};
};

/// The decision over all positions.
struct Choice {
  PlanOutcome outcome = PlanOutcome::Finished;
  std::optional<int> position;  ///< nothing unless Found
  double leastOverlap = 0.0;    ///< t as relaxed [mm^2]
  int relaxations = 0;
  bool tableAlone = false;  ///< nothing overlaps enough: the table alone will place the view
};

/// What a position promises: its traced void area where there is one, otherwise that of positional space [mm^2].
[[nodiscard]] inline double promise(const PositionScore& score) {
  return score.tracedVoidArea.value_or(score.voidArea);
}

/// The objective N(i) = o_v(i) if o_s(i) > t, else 0 (Pito 1999, 5.3), maximised over the positions. A tie goes to the
/// least motion from `current` if that is known, then to the lower index. When void is left above F but every such
/// position falls short of t or of a certain pose, both are relaxed up to `maxRelaxations` times, then given up where
/// the table may place a view alone, and otherwise NoOverlap returned. Writes to every score which constraint bound and
/// by how much it was missed.
[[nodiscard]] Choice choose(std::vector<PositionScore>& scores, const Workspace& workspace, std::optional<int> current,
                            const ChoiceOptions& options);

}  // namespace vantage
