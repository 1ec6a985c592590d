#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "registration/motion_information.h"
#include "registration/pose_covariance.h"
#include "scanner/view.h"

namespace vantage {

/// What is known of the motion between two views besides their surfaces: T_object_to is a small motion, distributed as
/// the prior says, of T_object_from * T_from_to.
struct PoseTie {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose T_from_to = Pose::Identity();
  PosePrior prior;
};

struct MultiViewOptions {
  std::optional<double> coarseGate;   ///< largest distance of a pair at the beginning [mm]; unset: by the scale
  std::optional<double> finalGate;    ///< and at the end [mm]; unset: by the scale (see RegistrationScale)
  double maxAngle = radians(35.0);    ///< between the normals of a pair [rad]
  std::optional<double> hiddenDepth;  ///< surface farther behind counts as hidden [mm]; unset: by the scale
  double minOverlap = 0.03;           ///< share of a view's points that must meet another view for the two to be tied
  /// Points looked up per round, shared by all pairs of views; each direction of a pair gets at least `leastPoints`.
  std::size_t coarsePoints = 30000;  ///< until the poses settle
  std::size_t finePoints = 300000;   ///< in the last rounds
  std::size_t leastPoints = 500;
  int maxIterations = 40;
  double tolerance = 2e-3;  ///< the poses have settled when points move less than this [mm]
  /// What the mechanics know of the motions between views: a chain of moves does not forget what was commanded, however
  /// often the poses are refined. A view that no tie leads to is held at its pose by 3 degrees and a fortieth of its
  /// extent about its centroid, which decides about motions that no pair of views holds.
  std::vector<PoseTie> ties;
  /// Where the views were said to be, one pose per view, or none: along motions that no pairs hold they go back there,
  /// as seen from the first view.
  std::vector<Pose> given;
};

struct MultiViewResult {
  std::vector<Pose> poses;  ///< one per view, T_object_scanner; the first is the given one to the last bit
  double rmsBefore = 0.0;   ///< of the overlaps, distances beyond the final gate counting as the gate [mm]
  double rmsAfter = 0.0;    ///< larger only where ties outweigh it, and by less than 2 %
  std::size_t pairs = 0;    ///< of points, in the last round
  int iterations = 0;
  bool improved = false;  ///< false: the poses are the given ones
  /// Per view, how far off its points may be against the first view by what all pairs of all views say, without priors
  /// and ties: one sigma of the weakest motion [mm]. 0 for the first, 1000 fine gates and more where nothing holds.
  std::vector<double> poseSigmas;
  PoseCovariance covariance;  ///< the same against any other view
};

/// Refines the poses of all views at once: minimises the symmetric point-to-plane distances of all overlapping pairs of
/// views (projective association both ways, gates coarse to fine, Geman-McClure weights), one sparse system of 6 (n -
/// 1) unknowns per round. The error that a chain of registrations piles up where it closes is spread over all views.
///
/// Poses are taken over only if the robust error falls, or if they are nearer to what the ties say and it rises by less
/// than 2 %. Deterministic for any thread count.
/// @throws InvalidInput when the options contradict each other or a tie is not of two of the views, or for given poses
/// that are not one per view; Cancelled
[[nodiscard]] MultiViewResult refineViews(std::span<const View> views, const MultiViewOptions& options,
                                          const Progress& progress = {});

}  // namespace vantage
