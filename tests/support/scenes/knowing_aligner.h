#pragma once

#include <utility>
#include <vector>

#include "acquisition/stand_aligner.h"

namespace vantage::testing {

/// An aligner that need not look: it was told what to say.
class KnowingAligner final : public StandAligner {
 public:
  KnowingAligner(AlignmentVerdict verdict, std::vector<StandPose> candidates) {
    said_.verdict = verdict;
    said_.reason = verdict == AlignmentVerdict::Good        ? AlignmentReason::OnePose
                   : verdict == AlignmentVerdict::Ambiguous ? AlignmentReason::SeveralPoses
                                                            : AlignmentReason::Contradiction;
    said_.candidates = std::move(candidates);
  }

  [[nodiscard]] AlignedStand align(const Composite& object, const Composite& stand, const PickedPairs& picks,
                                   const Progress& /*progress*/) const override {
    objectViews = object.views.size();
    standViews = stand.views.size();
    AlignedStand aligned{said_, {}};
    aligned.alignment.picked = !picks.empty();
    return aligned;
  }

  /// What it was asked last.
  mutable std::size_t objectViews = 0;
  mutable std::size_t standViews = 0;

 private:
  StandAlignment said_;
};

/// A pose that an aligner might find.
[[nodiscard]] inline StandPose poseAt(const Pose& T_object_stand, bool possible) {
  return {T_object_stand, 0.4, 0.1, possible ? 0.0 : 0.03, 0.0, 0.001, possible ? 0.4 : 0.1, possible};
}

}  // namespace vantage::testing
