#include "acquisition/stand_aligner.h"

#include <algorithm>
#include <utility>

#include "composites/composite_alignment.h"

namespace vantage {
namespace {

StandPose standPoseOf(const AlignedPose& pose, bool possible) {
  const PoseEvidence& evidence = pose.evidence;
  return {pose.refinement ? pose.refinement->T_reference_moved : pose.T_reference_moved,
          evidence.overlap,
          evidence.rms,
          evidence.conflict,
          evidence.table,
          evidence.missing,
          pose.score,
          possible};
}

AlignedStand alignedStandOf(const CompositeAlignment& found) {
  AlignedStand stand;
  StandAlignment& alignment = stand.alignment;
  alignment.verdict = found.judgement.verdict;
  alignment.reason = found.judgement.reason;
  alignment.value = found.judgement.value;
  alignment.sameSurface = found.sameSurface;
  const std::vector<std::size_t>& choice = found.judgement.choice;
  for (std::size_t i = 0; i < found.poses.size(); ++i)
    alignment.candidates.push_back(
        standPoseOf(found.poses[i], std::find(choice.begin(), choice.end(), i) != choice.end()));
  const std::size_t best = choice.empty() ? 0 : choice.front();
  if (found.poses.empty() || !found.poses[best].refinement) return stand;
  const JointRefinement& refinement = *found.poses[best].refinement;
  stand.poses = refinement.reference;
  stand.poses.insert(stand.poses.end(), refinement.moved.begin(), refinement.moved.end());
  return stand;
}

class CompositeAligner final : public StandAligner {
 public:
  [[nodiscard]] AlignedStand align(const Composite& object, const Composite& stand, const PickedPairs& picks,
                                   const Progress& progress) const override {
    const CompositeModel reference(object, progress.part(0.0, 0.1));
    const CompositeModel moved(stand, progress.part(0.1, 0.2));
    const Progress aligning = progress.part(0.2, 1.0);
    AlignedStand aligned = alignedStandOf(picks.empty() ? alignComposites(reference, moved, {}, aligning)
                                                        : alignPicked(reference, moved, picks, {}, aligning));
    aligned.alignment.picked = !picks.empty();
    return aligned;
  }
};

}  // namespace

const StandAligner& usualStandAligner() {
  static const CompositeAligner aligner;
  return aligner;
}

}  // namespace vantage
