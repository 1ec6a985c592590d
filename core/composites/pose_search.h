#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "composites/pose_evidence.h"

namespace vantage {

struct PoseSearchOptions {
  std::size_t starts = 1000;           ///< rotations that are tried, spread evenly over all
  std::size_t coarse = 20;             ///< poses kept of each of the two lists of the coarse search
  std::size_t medium = 8;              ///< poses kept of the medium search
  double sameTurn = radians(8.0);      ///< coarse poses nearer in turn, and in shift, are one [rad]
  double distinctTurn = radians(2.0);  ///< at the end, those farther apart in turn or shift are two [rad]
};

/// Of the contradictions of poses that are fitted finely, see scoreOf.
inline constexpr double kFineTolerance = 0.01;

/// A pose that the composites fit in, as far as they do.
struct FoundPose {
  Pose T_reference_moved = Pose::Identity();
  PoseEvidence evidence;
  double score = 0.0;  ///< overlap, small residuals and no contradictions, 0..1
};

/// How good a pose is, by its evidence: overlap (1 - (rms / limit)^2) exp(-(conflict + table + missing / 2) /
/// tolerance).
/// @param tolerance of contradictions, a share of the surface
[[nodiscard]] double scoreOf(const PoseEvidence& evidence, const AlignmentLimits& limits, double tolerance);

/// How far apart two poses of a composite are.
struct PoseDistance {
  double turn = 0.0;   ///< [rad]
  double shift = 0.0;  ///< of the composite's centroid [mm]
};
[[nodiscard]] PoseDistance distanceOf(const Pose& a, const Pose& b, const Vec3& centroid);

/// All poses of one composite against another that are worth a look, the best first: turns spread over all that there
/// are, centroid on centroid, fitted coarsely, the best of them finer and finer. Poses that free space speaks against
/// are among them with the evidence. Deterministic for any thread count; may be empty. @throws Cancelled
[[nodiscard]] std::vector<FoundPose> searchPoses(const CompositeModel& reference, const CompositeModel& moved,
                                                 const PoseSearchOptions& options, const Progress& progress = {});

/// Poses that are known roughly, fitted as the last steps of a search do: the second coarse round, medium and fine. The
/// best first. @throws Cancelled
[[nodiscard]] std::vector<FoundPose> fitPoses(const CompositeModel& reference, const CompositeModel& moved,
                                              std::span<const Pose> starts, const PoseSearchOptions& options,
                                              const Progress& progress = {});

}  // namespace vantage
