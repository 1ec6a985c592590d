#pragma once

#include <cstddef>
#include <optional>

#include "base/progress.h"
#include "registration/registration_target.h"
#include "registration/verdict.h"
#include "registration/view_surface.h"

namespace vantage {

struct IcpOptions {
  /// Where the view may be, around its start pose. Unset: 3 degrees and a fortieth of the view's extent about its
  /// centroid, all directions.
  std::optional<PosePrior> prior;
  std::optional<double> coarseGate;    ///< largest distance of a pair at the beginning [mm]; unset: by the scale
  std::optional<double> finalGate;     ///< and at the end [mm]; unset: by the scale (see RegistrationScale)
  double coarseAngle = radians(45.0);  ///< largest angle between the normals of a pair at the beginning [rad]
  double finalAngle = radians(35.0);   ///< and at the end [rad]
  std::optional<double> hiddenDepth;   ///< model surface farther behind counts as hidden [mm]; unset: by the scale
  std::size_t coarsePoints = 4000;     ///< of the model, until the pose settles
  std::size_t finePoints = 60000;      ///< of the model, in the last rounds
  int maxIterations = 60;
  double tolerance = 1e-3;   ///< the pose has settled when points move less than this [mm]
  bool searchRivals = true;  ///< look for other poses that fit as well (repetitive shapes)
  VerdictLimits limits;
};

struct RegistrationResult {
  Pose T_object_scanner = Pose::Identity();
  Verdict verdict = Verdict::Failed;
  Finding finding;             ///< what the verdict rests on
  double rms = 0.0;            ///< of the pairs, along the normals [mm]
  double inlierShare = 0.0;    ///< pairs among the model points that should have one, 0..1
  double conflictShare = 0.0;  ///< among those, points that the scanner looked through, 0..1
  std::size_t pairs = 0;
  int iterations = 0;
  Stability stability;     ///< of the pairs alone
  double poseSigma = 0.0;  ///< farthest that a point moves for one sigma of the weakest motion, with the prior [mm]
};

/// Point-to-plane ICP of a view against the model. Every round looks the model's points up along the view's rays
/// (projective association), drops pairs on a border, with normals that disagree or beyond a gate that shrinks from
/// coarse to fine, weighs the rest by confidence and robustly (Geman-McClure at 3 sigma of the median), and minimises
///   sum w (n . (q - p))^2 / sigma^2 + prior
/// with n the mean of both normals. Motions about which the pairs know no more than their normals' noise pretends are
/// left to the prior: a smooth cylinder does not creep about its axis.
///
/// Moving start pose and model by the same rigid motion moves the result by it. Deterministic for any thread count.
/// @param rays of the image that `view` was triangulated from
/// @throws InvalidInput for options that contradict each other, Cancelled
[[nodiscard]] RegistrationResult registerView(const ViewMesh& view, const RayGrid& rays, const Pose& T_object_scanner,
                                              const RegistrationTarget& model, const IcpOptions& options,
                                              const Progress& progress = {});

/// The same with a surface that was prepared before.
[[nodiscard]] RegistrationResult registerView(const ViewSurface& surface, const Pose& T_object_scanner,
                                              const RegistrationTarget& model, const IcpOptions& options,
                                              const Progress& progress = {});

}  // namespace vantage
