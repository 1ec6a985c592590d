#pragma once

#include <optional>

#include "composites/joint_refinement.h"
#include "composites/pose_search.h"
#include "registration/weak_direction.h"

namespace vantage {

/// A pose of one composite against another, with all that is known of it.
struct AlignedPose {
  Pose T_reference_moved = Pose::Identity();
  PoseEvidence evidence;  ///< after the refinement where there is one
  double score = 0.0;     ///< see scoreOf
  /// Least eigenvalue of the point-to-plane information per pair, turns measured by what they do at the radius: how
  /// firmly the surfaces hold the weakest motion. About 1/6 for a ball with relief, 0 where they slide.
  double leastInformation = 0.0;
  WeakMotions weakMotions;                    ///< the motions that are held least, in coordinates of the reference
  std::optional<JointRefinement> refinement;  ///< none for poses that were not worth it
};

}  // namespace vantage
