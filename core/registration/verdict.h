#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "registration/motion_information.h"

namespace vantage {

enum class Verdict : std::uint8_t {
  Good,
  Doubtful,  ///< usable, but something speaks against trusting it
  Failed,    ///< not to be integrated
};

[[nodiscard]] std::string_view name(Verdict verdict);

/// When a registration is doubtful and when it has failed.
struct VerdictLimits {
  std::size_t minPairs = 100;       ///< fewer: failed
  std::size_t fewPairs = 400;       ///< fewer: doubtful
  double minInlierShare = 0.4;      ///< of the expected overlap; less: failed
  double lowInlierShare = 0.75;     ///< less: doubtful
  double doubtfulConflicts = 0.04;  ///< share of points the scanner looked through
  double maxConflicts = 0.15;       ///< more: failed
  double doubtfulResidual = 2.0;    ///< robust residual, in multiples of what noise and spacing explain
  double maxResidual = 4.0;         ///< more: failed
  double doubtfulMotion = 4.0;      ///< distance from the start pose in sigmas of the prior
  double maxMotion = 7.0;           ///< more: failed
  double heldTolerance =
      1.0;  ///< where the mechanics alone hold a motion, so many times doubtful conflicts or residual: failed
  std::optional<double> maxPoseSigma;  ///< of the pairs alone [mm]; more: doubtful; unset: by the scale of the scans
};

/// What a registration has to show for itself.
struct Evidence {
  std::size_t pairs = 0;
  double inlierShare = 0.0;
  double conflictShare = 0.0;
  double residual = 0.0;       ///< in multiples of what noise and spacing explain
  double motion = 0.0;         ///< in sigmas of the prior
  int heldByPrior = 0;         ///< number of independent motions that the pairs leave to the prior
  bool settled = false;        ///< the iterations came to rest
  double rivalDistance = 0.0;  ///< how far off another pose fits as well [mm]; 0: none
  Stability stability;         ///< of the pairs alone
};

/// What a verdict rests on.
enum class VerdictReason : std::uint8_t {
  NotRegistered,      ///< nothing was registered yet
  FirstView,          ///< the first view of an acquisition: it defines the frame
  FirstImported,      ///< the first of recorded scans: the others are brought to it
  EarlierVersion,     ///< an earlier version registered it and left no reason that is known
  Inliers,            ///< enough of the expected overlap fits [share, 0..1]
  FewInliers,         ///< too little of the expected overlap fits [share, 0..1]
  FewPairs,           ///< so few points overlap with the model
  Conflicts,          ///< the scanner looked through the model's surface [share of points, 0..1]
  Residual,           ///< the surfaces differ by more than noise and spacing explain [multiples of that]
  Motion,             ///< it moved away from where the mechanics put it [sigmas of the prior]
  Rival,              ///< another pose fits as well, so far away [mm]
  HeldByMechanics,    ///< the surface lets go of some motions; the mechanics alone hold them
  NotSettled,         ///< the pose had not come to rest when the iterations ran out
  ContradictsOthers,  ///< it contradicts what the other scans agree on [share of points, 0..1]
  NoPoseGiven,        ///< nobody said where it was taken from, and its surface alone does not tell
  OtherPosition,      ///< it fits another position than it was said to be of [index of the position that it fits]
  OtherTurns,         ///< it fits where every turn is another multiple of the list's [turned / listed]
  InverseList,        ///< it fits where the list has the inverse of every pose
  OtherUnit,          ///< it fits where positions of the list are in another unit [mm per unit]
  OtherFrame,         ///< it fits where two axes of the scanner point the other way [1 x, 2 y, 3 z: the one that stays]
  AxisBeside,         ///< it fits where the axis lies beside the list's [mm]
  TableAlone,         ///< it shows next to nothing of the model: it is where the table has it [points that overlap]
  HeldByAll,          ///< too little of the model held it, all scans together do
  TableSlipped,       ///< it fits where the table would have turned by so much more than it says [deg, ccw from above]
  OtherTurn,          ///< it fits where the table stands at that angle, not where it was said to [deg, ccw from above]
  TakenElsewhere,     ///< the operator took it as from that angle of the table, where it fits [deg, ccw from above]
  OnDoubtful,         ///< it fits only together with scans whose own place is doubtful
  HeldByFew,          ///< too few scans hold it to those that hold each other
  TableInDoubt,       ///< the table alone says where it belongs, and the scan before fits another turn of the table
};
inline constexpr VerdictReason kLastVerdictReason = VerdictReason::TableInDoubt;

/// "not_registered", "first_view", ..., "table_in_doubt".
[[nodiscard]] std::string_view name(VerdictReason reason);

/// The gravest thing that was found about a registration.
struct Finding {
  VerdictReason reason = VerdictReason::NotRegistered;
  std::optional<double> value;      ///< what was measured, in the unit of the reason; none where there is no measure
  WeakMotions motions;              ///< those that the surface lets go of; only with HeldByMechanics
  std::vector<double> rivals = {};  ///< further values that are as good as the first; only with OtherTurn

  friend bool operator==(const Finding&, const Finding&) = default;
};

struct Judgement {
  Verdict verdict = Verdict::Failed;
  Finding finding;
};

/// The first thing found wrong decides, in the order of the limits; nothing wrong is Inliers and Good.
[[nodiscard]] Judgement judge(const Evidence& evidence, const VerdictLimits& limits);

}  // namespace vantage
