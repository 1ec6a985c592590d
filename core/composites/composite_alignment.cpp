#include "composites/composite_alignment.h"

#include <algorithm>
#include <utility>

#include "composites/two_sided_fit.h"
#include "registration/pair_term.h"

namespace vantage {
namespace {

// Poses are refined that might become possible: with so many times the contradiction that a possible one may have.
constexpr double kMightBe = 5.0;
// A surface is the same after a motion when so much of it lies on itself.
constexpr double kSameOverlap = 0.85;

class Alignment {
 public:
  Alignment(const CompositeModel& reference, const CompositeModel& moved, const CompositeAlignmentOptions& options)
      : reference_(reference), moved_(moved), options_(options), limits_(limitsOf(reference.scale(), moved.scale())) {
    limits_.residual = std::max(reference.residual(), moved.residual());
  }

  [[nodiscard]] CompositeAlignment judged(std::span<const FoundPose> found, const Progress& progress) const {
    CompositeAlignment result;
    std::size_t refined = 0;
    bool slides = false;  // then rivals change nothing
    for (const FoundPose& pose : found) {
      result.poses.push_back({pose.T_reference_moved, pose.evidence, pose.score, 0.0, {}, {}});
      const auto n = static_cast<double>(std::min(found.size(), options_.refined));
      const auto k = static_cast<double>(refined);
      if (refined >= options_.refined || slides || (refined > 0 && !mightBe(pose, found.front()))) continue;
      refine(result.poses.back(), progress.part(0.95 * k / n, 0.95 * (k + 1.0) / n));
      ++refined;
      slides = isPossible(result.poses.back(), limits_, options_.limits) &&
               result.poses.back().leastInformation < options_.limits.leastInformation;
    }
    std::stable_sort(result.poses.begin(), result.poses.end(),
                     [](const AlignedPose& a, const AlignedPose& b) { return a.score > b.score; });
    dropRepeated(result.poses);
    result.judgement = judgeAlignment(result.poses, limits_, options_.limits);
    if (result.judgement.choice.size() > 1)
      result.sameSurface = leaveSameSurface(result, progress.part(0.95, 1.0, "check"));
    return result;
  }

 private:
  [[nodiscard]] bool mightBe(const FoundPose& pose, const FoundPose& best) const {
    return pose.evidence.contradiction() <= kMightBe * options_.limits.contradiction &&
           pose.evidence.missing <= 2.0 * options_.limits.missing && pose.score > 0.1 * best.score;
  }

  // Moves the views of both to where they agree best, and asks for the evidence anew.
  void refine(AlignedPose& pose, const Progress& progress) const {
    pose.refinement = refineTogether(reference_, moved_, pose.T_reference_moved, options_.refinement,
                                     progress.part(0.0, 0.8, "refine"));
    pose.T_reference_moved = pose.refinement->T_reference_moved;
    const CompositeModel reference = reference_.withPoses(pose.refinement->reference);
    std::vector<Pose> own;
    for (const Pose& T : pose.refinement->moved) own.push_back(pose.T_reference_moved.inverse() * T);
    const CompositeModel moved = moved_.withPoses(own);
    pose.evidence = evidenceOf(reference, moved, pose.T_reference_moved, limits_, progress.part(0.8, 1.0, "check"));
    pose.score = scoreOf(pose.evidence, limits_, kFineTolerance);
    weigh(reference, moved, pose);
  }

  // How firmly the surfaces hold each other.
  void weigh(const CompositeModel& reference, const CompositeModel& moved, AlignedPose& pose) const {
    const TwoSidedFit fit(reference, moved, PointLevel::Fine, TwoSidedFit::Lookup::Exact, limits_.conflict());
    const std::vector<Pair> pairs = fit.pairs(pose.T_reference_moved, limits_.sampleGate());
    const auto count =
        std::count_if(pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.state == PairState::Paired; });
    PairStability firmness;
    firmness.add(pairs, Pose::Identity());
    const Stability stability = firmness.analyse(1.0);
    pose.leastInformation = stability.eigenvalues[0] / static_cast<double>(std::max<std::ptrdiff_t>(count, 1));
    pose.weakMotions = stability.weakMotions;
  }

  // Refined poses that came to lie in the same place count once.
  void dropRepeated(std::vector<AlignedPose>& poses) const {
    std::vector<AlignedPose> kept;
    for (AlignedPose& pose : poses) {
      const bool repeated = std::any_of(kept.begin(), kept.end(), [&](const AlignedPose& other) {
        const PoseDistance d = distanceOf(pose.T_reference_moved, other.T_reference_moved, moved_.centroid());
        return d.turn < options_.search.distinctTurn && d.shift < limits_.distinctShift();
      });
      if (!repeated) kept.push_back(std::move(pose));
    }
    poses = std::move(kept);
  }

  // Whether what leads from one possible pose to another brings the reference onto itself.
  [[nodiscard]] bool leaveSameSurface(const CompositeAlignment& result, const Progress& progress) const {
    const Pose& best = result.poses[result.judgement.choice.front()].T_reference_moved;
    for (const std::size_t k : result.judgement.choice) {
      const Pose motion = result.poses[k].T_reference_moved * best.inverse();
      const PoseEvidence self = evidenceOf(reference_, reference_, motion, limits_, progress);
      if (self.overlap < kSameOverlap || self.contradiction() > options_.limits.contradiction ||
          self.missing > options_.limits.missing)
        return false;
    }
    return true;
  }

  const CompositeModel& reference_;
  const CompositeModel& moved_;
  const CompositeAlignmentOptions& options_;
  AlignmentLimits limits_;
};

}  // namespace

MultiViewOptions refinementOfComposites() {
  MultiViewOptions options;
  options.coarsePoints = 15'000;
  options.finePoints = 60'000;
  options.leastPoints = 150;
  options.maxIterations = 25;
  return options;
}

CompositeAlignment alignComposites(const CompositeModel& reference, const CompositeModel& moved,
                                   const CompositeAlignmentOptions& options, const Progress& progress) {
  const std::vector<FoundPose> found = searchPoses(reference, moved, options.search, progress.part(0.0, 0.4, "search"));
  return Alignment(reference, moved, options).judged(found, progress.part(0.4, 1.0));
}

CompositeAlignment alignFrom(const CompositeModel& reference, const CompositeModel& moved,
                             const Pose& T_reference_moved, const CompositeAlignmentOptions& options,
                             const Progress& progress) {
  const std::vector<Pose> starts{T_reference_moved};
  const std::vector<FoundPose> found =
      fitPoses(reference, moved, starts, options.search, progress.part(0.0, 0.4, "search"));
  return Alignment(reference, moved, options).judged(found, progress.part(0.4, 1.0));
}

CompositeAlignment alignPicked(const CompositeModel& reference, const CompositeModel& moved,
                               std::span<const PickedPair> pairs, const CompositeAlignmentOptions& options,
                               const Progress& progress) {
  return alignFrom(reference, moved, poseOfPairs(reference, moved, pairs), options, progress);
}

}  // namespace vantage
