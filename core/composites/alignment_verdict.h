#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "composites/aligned_pose.h"

namespace vantage {

enum class AlignmentVerdict : std::uint8_t {
  Good,       ///< one pose is possible, and it is held
  Ambiguous,  ///< several are, or it slides
  Failed,     ///< none is
};

/// What a verdict rests on.
enum class AlignmentReason : std::uint8_t {
  OnePose,        ///< good: exactly one pose is possible [overlap, share 0..1]
  Slides,         ///< ambiguous: the surfaces let go of motions [information of the weakest, of 1]
  SeveralPoses,   ///< ambiguous: so many poses are possible [number]
  Contradiction,  ///< failed: rays of one went through the surface of the other, or it is below a table [share, 0..1]
  TooLittleOverlap,  ///< failed: too little surface of one is in the other [overlap, share 0..1]
  BentComposite,     ///< failed: a composite does not fit itself: its views moved by more than the mechanics [sigmas]
  OtherObject,       ///< failed: no pose fits, as with another object [residual, mm]
};
inline constexpr AlignmentReason kLastAlignmentReason = AlignmentReason::OtherObject;

/// "good", "ambiguous", "failed".
[[nodiscard]] std::string_view name(AlignmentVerdict verdict);
/// "one_pose", "slides", "several_poses", "contradiction", "too_little_overlap", "bent_composite", "other_object".
[[nodiscard]] std::string_view name(AlignmentReason reason);

/// What makes a pose possible, and what tells poses from each other.
struct AlignmentVerdictLimits {
  double contradiction = 0.003;    ///< most surface that rays or a table speak against [share, 0..1]
  double missing = 0.06;           ///< most surface that should have been seen and was not [share, 0..1]
  double overlap = 0.03;           ///< least [share, 0..1]
  double leastInformation = 4e-4;  ///< of the weakest motion: with less the composites slide along each other, of 1
  double rivalResidual = 2.0;      ///< a rival may lie so many times farther off than the best,
  double rivalSlack = 0.5;         ///< and so much more [sigmas of the noise],
  double rivalScore = 0.3;         ///< if its score is at least this share of the best's
  double tension = 7.0;  ///< of ties: where no pose fits and one is stretched more, a composite is bent [sigmas]
};

struct AlignmentJudgement {
  AlignmentVerdict verdict = AlignmentVerdict::Failed;
  AlignmentReason reason = AlignmentReason::OtherObject;
  std::optional<double> value;      ///< in the unit of the reason
  std::vector<std::size_t> choice;  ///< indices of the possible poses that it is between, the best first
};

/// Whether nothing speaks against a pose.
[[nodiscard]] bool isPossible(const AlignedPose& pose, const AlignmentLimits& limits,
                              const AlignmentVerdictLimits& verdictLimits);

/// @param poses the best first
[[nodiscard]] AlignmentJudgement judgeAlignment(std::span<const AlignedPose> poses, const AlignmentLimits& limits,
                                                const AlignmentVerdictLimits& verdictLimits);

}  // namespace vantage
