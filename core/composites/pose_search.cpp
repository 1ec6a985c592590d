#include "composites/pose_search.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/parallel.h"
#include "composites/even_rotations.h"
#include "composites/two_sided_fit.h"

namespace vantage {
namespace {

using Lookup = TwoSidedFit::Lookup;

constexpr int kCoarseRounds = 10;
constexpr int kCloseRounds = 12;
constexpr int kMediumRounds = 12;
constexpr int kFineRounds = 10;
constexpr std::size_t kKeptQuarter = 4;
constexpr double kCoarseTolerance = 0.03;
// Where a part of the surface is in conflict, the coarse score falls by so much of it.
constexpr double kConflictWeight = 2.0;

struct CoarsePose {
  Pose T_reference_moved = Pose::Identity();
  FitQuality quality;

  [[nodiscard]] double contradiction() const { return quality.conflict + quality.table; }
  // Two opinions of how good it is: one alone loses right poses with little overlap, or with some false conflict.
  [[nodiscard]] double byDifference() const { return quality.overlap - kConflictWeight * contradiction(); }
  [[nodiscard]] double byProduct() const { return quality.overlap * std::exp(-contradiction() / kCoarseTolerance); }
};

using Opinion = std::function<double(const CoarsePose&)>;

class Search {
 public:
  Search(const CompositeModel& reference, const CompositeModel& moved, const PoseSearchOptions& options)
      : reference_(reference), moved_(moved), options_(options), limits_(limitsOf(reference.scale(), moved.scale())) {}

  [[nodiscard]] std::vector<CoarsePose> starts() const {
    std::vector<CoarsePose> poses;
    for (const Eigen::Quaterniond& turn : evenRotations(options_.starts)) {
      Pose T = Pose::Identity();
      T.linear() = turn.toRotationMatrix();
      T.translation() = reference_.centroid() - T.linear() * moved_.centroid();
      poses.push_back({T, {}});
    }
    return poses;
  }

  void fitCoarse(std::vector<CoarsePose>& poses, const TwoSidedFit::Schedule& schedule,
                 const Progress& progress) const {
    const TwoSidedFit fit(reference_, moved_, PointLevel::Coarse, Lookup::Field, limits_.conflict());
    parallelChunks(poses.size(), 4, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        poses[k].T_reference_moved = fit.run(poses[k].T_reference_moved, schedule);
        poses[k].quality = fit.quality(poses[k].T_reference_moved, schedule.lastGate);
      }
    });
  }

  void fitClose(std::vector<CoarsePose>& poses, const Progress& progress) const {
    fitCoarse(poses, {limits_.nearGate(), limits_.closeGate(), kCloseRounds}, progress);
  }

  [[nodiscard]] std::vector<CoarsePose> coarse(const Progress& progress) const {
    std::vector<CoarsePose> poses = starts();
    fitCoarse(poses, {limits_.coarseGate(), limits_.nearGate(), kCoarseRounds}, progress.part(0.0, 0.7));
    poses = bestOfBoth(poses, poses.size() / kKeptQuarter / 2, 0.0);
    fitClose(poses, progress.part(0.7, 1.0));
    return bestOfBoth(poses, options_.coarse, options_.sameTurn);
  }

  // Fits the poses, judges them, and keeps the best that differ.
  [[nodiscard]] std::vector<FoundPose> medium(std::span<const CoarsePose> poses, const Progress& progress) const {
    const TwoSidedFit fit(reference_, moved_, PointLevel::Medium, Lookup::Exact, limits_.conflict());
    std::vector<FoundPose> found(poses.size());
    parallelChunks(poses.size(), 1, progress, [&](std::size_t k, std::size_t) {
      FoundPose& pose = found[k];
      pose.T_reference_moved =
          fit.run(poses[k].T_reference_moved, {limits_.mediumGate(), limits_.sampleGate(), kMediumRounds});
      const FitQuality quality = fit.quality(pose.T_reference_moved, limits_.sampleGate());
      pose.evidence = {quality.overlap, quality.rms, quality.conflict, quality.table, 0.0};
      pose.score = scoreOf(pose.evidence, limits_, kCoarseTolerance);
    });
    return distinct(std::move(found), options_.medium);
  }

  [[nodiscard]] std::vector<FoundPose> fine(std::vector<FoundPose> poses, const Progress& progress) const {
    const TwoSidedFit fit(reference_, moved_, PointLevel::Fine, Lookup::Exact, limits_.conflict());
    parallelChunks(poses.size(), 1, progress.part(0.0, 0.6), [&](std::size_t k, std::size_t) {
      poses[k].T_reference_moved =
          fit.run(poses[k].T_reference_moved, {limits_.sampleGate(), limits_.fineGate(), kFineRounds});
    });
    const auto n = static_cast<double>(poses.size());
    double done = 0.0;
    for (FoundPose& pose : poses) {
      pose.evidence = evidenceOf(reference_, moved_, pose.T_reference_moved, limits_,
                                 progress.part(0.6 + 0.4 * done / n, 0.6 + 0.4 * (done + 1.0) / n));
      pose.score = scoreOf(pose.evidence, limits_, kFineTolerance);
      done += 1.0;
    }
    return distinct(std::move(poses), options_.medium);
  }

 private:
  // The best by either opinion; those that are the same within `turn` count once.
  [[nodiscard]] std::vector<CoarsePose> bestOfBoth(std::vector<CoarsePose> poses, std::size_t count,
                                                   double turn) const {
    std::vector<CoarsePose> kept;
    for (const Opinion& opinion : {Opinion([](const CoarsePose& p) { return p.byDifference(); }),
                                   Opinion([](const CoarsePose& p) { return p.byProduct(); })}) {
      std::stable_sort(poses.begin(), poses.end(),
                       [&](const CoarsePose& a, const CoarsePose& b) { return opinion(a) > opinion(b); });
      std::vector<CoarsePose> rest;
      std::size_t taken = 0;
      for (const CoarsePose& pose : poses) {
        if (taken < count && !isAmong(pose, kept, turn)) {
          kept.push_back(pose);
          ++taken;
        } else {
          rest.push_back(pose);
        }
      }
      poses = std::move(rest);
    }
    return kept;
  }

  [[nodiscard]] bool isAmong(const CoarsePose& pose, std::span<const CoarsePose> kept, double turn) const {
    return turn > 0.0 && std::any_of(kept.begin(), kept.end(), [&](const CoarsePose& other) {
             const PoseDistance d = distanceOf(pose.T_reference_moved, other.T_reference_moved, moved_.centroid());
             return d.turn < turn && d.shift < limits_.reliefStep();
           });
  }

  // The best `count` poses that differ from each other.
  [[nodiscard]] std::vector<FoundPose> distinct(std::vector<FoundPose> poses, std::size_t count) const {
    std::stable_sort(poses.begin(), poses.end(),
                     [](const FoundPose& a, const FoundPose& b) { return a.score > b.score; });
    std::vector<FoundPose> kept;
    for (const FoundPose& pose : poses) {
      if (kept.size() >= count) break;
      if (std::none_of(kept.begin(), kept.end(), [&](const FoundPose& other) {
            const PoseDistance d = distanceOf(pose.T_reference_moved, other.T_reference_moved, moved_.centroid());
            return d.turn < options_.distinctTurn && d.shift < limits_.distinctShift();
          }))
        kept.push_back(pose);
    }
    return kept;
  }

  const CompositeModel& reference_;
  const CompositeModel& moved_;
  PoseSearchOptions options_;
  AlignmentLimits limits_;
};

}  // namespace

double scoreOf(const PoseEvidence& evidence, const AlignmentLimits& limits, double tolerance) {
  const double residual = evidence.rms / (limits.sampleGate() / 1.5);
  const double contradiction = evidence.contradiction() + 0.5 * evidence.missing;
  return evidence.overlap * std::max(0.0, 1.0 - residual * residual) * std::exp(-contradiction / tolerance);
}

PoseDistance distanceOf(const Pose& a, const Pose& b, const Vec3& centroid) {
  return {Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle(), (a * centroid - b * centroid).norm()};
}

std::vector<FoundPose> searchPoses(const CompositeModel& reference, const CompositeModel& moved,
                                   const PoseSearchOptions& options, const Progress& progress) {
  const Search search(reference, moved, options);
  const std::vector<CoarsePose> coarse = search.coarse(progress.part(0.0, 0.5, "search"));
  std::vector<FoundPose> medium = search.medium(coarse, progress.part(0.5, 0.7));
  return search.fine(std::move(medium), progress.part(0.7, 1.0));
}

std::vector<FoundPose> fitPoses(const CompositeModel& reference, const CompositeModel& moved,
                                std::span<const Pose> starts, const PoseSearchOptions& options,
                                const Progress& progress) {
  const Search search(reference, moved, options);
  std::vector<CoarsePose> coarse;
  for (const Pose& start : starts) coarse.push_back({start, {}});
  search.fitClose(coarse, progress.part(0.0, 0.2, "search"));
  std::vector<FoundPose> medium = search.medium(coarse, progress.part(0.2, 0.4));
  return search.fine(std::move(medium), progress.part(0.4, 1.0));
}

}  // namespace vantage
