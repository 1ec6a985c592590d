#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "planning/plan.h"

namespace vantage {

/// Why a position was chosen, or why not: every figure is one of the plan's record or follows from them.
struct Explanation {
  int position = 0;
  Constraint constraint = Constraint::BelowThreshold;  ///< what decided
  double shortBy = 0.0;                  ///< by how much the constraint is missed; mm^2, for PoseUncertain mm
  double voidArea = 0.0;                 ///< o_v by positional space [mm^2]
  std::optional<double> tracedVoidArea;  ///< o_v by the scanner's own rays [mm^2]
  double promise = 0.0;                  ///< the o_v that counts: traced if there is one [mm^2]
  double overlapArea = 0.0;              ///< o_s [mm^2]
  double leastOverlap = 0.0;             ///< t [mm^2]
  bool tableAlone = false;               ///< nothing overlaps enough: the table alone will place the view
  double terminationThreshold = 0.0;     ///< F [mm^2]
  std::optional<PlanForecast> forecast;  ///< what o_v rests on where it is a forecast of new surface
  std::optional<double> poseSigma;       ///< predicted registration error along the weak direction [mm]
  WeakMotions weakMotions;               ///< what that direction is; empty when not predicted
  std::size_t patches = 0;               ///< void patches that it would see; 0 unless traced
  double patchArea = 0.0;                ///< sum of their weights [mm^2]
  std::array<std::size_t, kEdgeClasses> patchesByClass{};  ///< by EdgeClass
  int rank = 0;               ///< 1 for the most promising of all positions; ties go to the lower index
  std::optional<int> rival;   ///< what to compare with: the choice; for the choice, the runner-up
  double rivalPromise = 0.0;  ///< [mm^2]
  double rivalOverlap = 0.0;  ///< [mm^2]
};

/// @throws InvalidInput when the plan has no such position.
[[nodiscard]] Explanation explain(const Plan& plan, int position);

/// The most promising position that is allowed but not chosen; the lower index wins a tie. Nothing when there is none.
[[nodiscard]] std::optional<int> runnerUp(const Plan& plan);

}  // namespace vantage
