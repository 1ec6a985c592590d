#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "composites/alignment_verdict.h"
#include "geometry/vectors.h"

namespace vantage {

inline constexpr AlignmentVerdict kLastAlignmentVerdict = AlignmentVerdict::Failed;

/// One way in which a composite may lie in the object, with what speaks for and against it. Shares are 0..1.
struct StandPose {
  Pose T_object_stand = Pose::Identity();  ///< from the composite's frame, that of the table in its stand
  double overlap = 0.0;                    ///< share of the surface on that of the other composite
  double rms = 0.0;                        ///< distance there [mm]
  double conflict = 0.0;                   ///< share that rays of the other composite went through
  double table = 0.0;                      ///< share below the table of the other
  double missing = 0.0;                    ///< share that the other should have seen and did not
  double score = 0.0;                      ///< larger is better
  bool possible = false;                   ///< nothing speaks against it
};

/// Who decided on a pose.
enum class PoseChoice : std::uint8_t {
  Evidence,  ///< the verdict was good
  Operator,  ///< chosen among the possible ones
  Despite,   ///< the operator uses it although something speaks against it
};
inline constexpr PoseChoice kLastPoseChoice = PoseChoice::Despite;
/// "evidence", "operator", "despite".
[[nodiscard]] std::string_view name(PoseChoice choice);

/// What came of aligning a stand's composite with the object.
struct StandAlignment {
  AlignmentVerdict verdict = AlignmentVerdict::Failed;
  AlignmentReason reason = AlignmentReason::OtherObject;
  std::optional<double> value;
  std::vector<StandPose> candidates;  ///< all distinct poses that were found, the best first
  bool sameSurface = false;           ///< ambiguous, but all possible poses leave the same surface
  bool picked = false;                ///< the search began with points that the operator picked
  std::optional<int> used;            ///< the candidate that the stand was placed by
  PoseChoice choice = PoseChoice::Evidence;
};

}  // namespace vantage
