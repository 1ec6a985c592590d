#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

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
  double voidArea = 0.0;     ///< o_v: confidence-weighted void patch area by positional space [mm^2]
  double overlapArea = 0.0;  ///< o_s: confidence-weighted model area by positional space [mm^2]
  /// The same as o_v, with the scanner's own rays; only where positional space proposed the position [mm^2].
  std::optional<double> tracedVoidArea;
  std::optional<double> poseSigma;  ///< predicted error of registration along its weak direction [mm]
  WeakMotions weakMotions;          ///< what the overlap fixes worst; empty when not predicted
  Constraint constraint = Constraint::BelowThreshold;
  double shortBy = 0.0;                ///< how much the constraint is missed by, in its unit (mm^2 or mm)
  std::vector<std::uint32_t> patches;  ///< patches that it would see, by index; only where traced
};

/// Why a boundary edge is left (the certificate of termination).
enum class EdgeReason : std::uint8_t {
  OutOfReach,       ///< no ranging ray of any position reaches it
  TooSteep,         ///< reached, but always beyond the breakdown angle
  LightBlocked,     ///< the model blocks the light from everywhere else
  ReceiverBlocked,  ///< light reaches it, but no receiver would see it
  BelowThreshold,   ///< could be seen, but all that one view would add is below F
  Answered,         ///< views looked at it and found no surface
};
inline constexpr int kEdgeReasons = 6;
[[nodiscard]] std::string_view name(EdgeReason reason);

/// The state of one void patch for the planner.
struct PatchOutlook {
  std::uint8_t looks = 0;                          ///< views taken so far that should have sampled a surface there
  bool answered = false;                           ///< enough looks: it attracts no more views
  EdgeReason reason = EdgeReason::BelowThreshold;  ///< what keeps it void; meaningful once nothing is left to scan
  double promise = 0.0;  ///< most that any one position would show of it; known like the reason [mm^2]
};

/// The planner's answer and its explanation.
struct Plan {
  PlanOutcome outcome = PlanOutcome::Finished;
  int position = -1;                  ///< the next best view; -1 unless Found
  double leastOverlap = 0.0;          ///< t [mm^2]
  double terminationThreshold = 0.0;  ///< F [mm^2]
  /// What all views that are still possible together would show, known once none of them is worth taking [mm^2].
  double voidLeft = 0.0;
  int relaxations = 0;                       ///< how often t was halved to find a position
  double angularError = 0.0;                 ///< of positional space [rad]
  std::vector<PositionScore> scores;         ///< every position of the workspace, in order
  std::shared_ptr<const VoidSurface> voids;  ///< the void patches that it is about
  std::vector<PatchOutlook> outlook;         ///< per patch
};

}  // namespace vantage
