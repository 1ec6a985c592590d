#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "forecast/forecast_ledger.h"
#include "planning/patch_outlook.h"
#include "registration/weak_direction.h"
#include "void_space/void_patch.h"

namespace vantage {

enum class PlanOutcome : std::uint8_t {
  Found,      ///< there is a next best view
  Finished,   ///< no position promises more than the termination threshold
  NoOverlap,  ///< void is left to see, but nothing reaches it with enough overlap
};

[[nodiscard]] std::string_view name(PlanOutcome outcome);

/// What decided over a position: none for the choice itself, otherwise the constraint that bound first.
enum class Constraint : std::uint8_t {
  Chosen,
  Outscored,       ///< allowed, but another position promises more
  BelowThreshold,  ///< o_v does not exceed F
  OverlapShort,    ///< o_s falls short of t
  PoseUncertain,   ///< the overlap would not fix the pose to within the sample spacing
};
[[nodiscard]] std::string_view name(Constraint constraint);

/// What one position of the workspace promises.
struct PositionScore {
  int position = 0;
  /// o_v by positional space: confidence-weighted void patch area, or, of a plan that forecasts, new surface [mm^2].
  double voidArea = 0.0;
  double overlapArea = 0.0;  ///< o_s: confidence-weighted model area by positional space [mm^2]
  /// The same as o_v, with the scanner's own rays; only where positional space proposed the position [mm^2].
  std::optional<double> tracedVoidArea;
  std::optional<double> poseSigma;  ///< predicted error of registration along its weak direction [mm]
  WeakMotions weakMotions;          ///< what the overlap fixes worst; empty when not predicted
  Constraint constraint = Constraint::BelowThreshold;
  double shortBy = 0.0;                ///< how much the constraint is missed by, in its unit (mm^2 or mm)
  std::vector<std::uint32_t> patches;  ///< patches that it would see, by index; only where traced
  /// What counts of o_v as it was before the run's ledger corrected it; only of a plan that forecasts [mm^2].
  std::optional<double> uncorrected;
};

/// Surface that is believed to be left which positions would still show [mm^2].
struct SurfaceLeft {
  double area = 0.0;
  double least = 0.0;  ///< two standard deviations of the run's forecasts less, but not below 0
  double most = 0.0;   ///< and more
};

/// What a plan's forecast rests on.
struct PlanForecast {
  ForecastTrust trust;
  std::optional<SurfaceLeft> left;  ///< known once no view is worth taking
  bool probing = false;  ///< the choice promises less than F: it is to find out whether the prediction is right
};

/// The planner's answer and its explanation.
struct Plan {
  PlanOutcome outcome = PlanOutcome::Finished;
  std::optional<int> position;        ///< the next best view; nothing unless Found
  double leastOverlap = 0.0;          ///< t [mm^2]
  double terminationThreshold = 0.0;  ///< F [mm^2]
  /// What all views that are still possible together would show, known once none of them is worth taking [mm^2].
  double voidLeft = 0.0;
  int relaxations = 0;                       ///< how often t was halved to find a position
  bool tableAlone = false;                   ///< nothing overlaps enough: the table alone will place the view
  double angularError = 0.0;                 ///< of positional space [rad]
  std::vector<PositionScore> scores;         ///< every position of the workspace, in order
  std::shared_ptr<const VoidSurface> voids;  ///< the void patches that it is about
  std::vector<PatchOutlook> outlook;         ///< per patch
  std::optional<PlanForecast> forecast;      ///< nothing of a plan whose o_v is void patch area
};

}  // namespace vantage
