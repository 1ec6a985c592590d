#pragma once

#include <optional>
#include <span>

#include "registration/pose_prior.h"
#include "registration/weak_direction.h"

namespace vantage {

/// How firmly a set of oriented points holds a rigid body in place when it may slide along its own surface.
struct Stability {
  Vec3 centre = Vec3::Zero();       ///< weighted centroid of the points; motions below rotate about it [mm]
  double radius = 0.0;              ///< weighted RMS distance of the points from the centre [mm]
  Mat6 information = Mat6::Zero();  ///< inverse covariance of a motion: rotation [rad], then translation [mm]
  /// Of the information with rotations measured by what they do at `radius`, ascending [1/mm^2].
  Vec6 eigenvalues = Vec6::Zero();
  /// The motion that is held least, (rotation, translation) with (radius * rotation, translation) of length 1.
  Vec6 weakDirection = Vec6::Zero();
  WeakMotions weakMotions;  ///< that motion said plainly, with those that are as weak; empty before an analysis
  double poseSigma =
      0.0;  ///< farthest that a point moves for one sigma of the weak motion [mm]; infinite if nothing holds
};

struct StabilityOptions {
  double noiseSigma = 0.1;  ///< of a pair's distance [mm]
  /// Noise of a pair's normal [rad]. Noisy normals make a smooth cylinder look as if it could not turn; what they
  /// pretend is taken off the information.
  double normalSigma = 0.0;
  /// The same where it differs from point to point, one per point; empty: normalSigma for all. A large even plate with
  /// sure normals does not drown the small part on it that alone knows about turns.
  std::span<const double> normalSigmas;
  std::optional<PosePrior> prior;  ///< added to what the points tell
};

/// Sums over oriented points x_i, n_i, w_i of what they tell about motions around a centre c, in units of the weights:
/// pairs = sum w J J^T with J = ((x - c) x n, n), and how much of that the noise of the normals pretends.
class MotionSums {
 public:
  Mat6 pairs = Mat6::Zero();
  double weight = 0.0;

  /// @param normalSigma noise of the normal per axis [rad]
  void add(const Vec3& pointFromCentre, const Vec3& normal, double weight, double normalSigma);

  /// Sum of w sigma^2 (J J^T over three orthogonal normals, less that of the normal itself).
  [[nodiscard]] Mat6 pretended() const;

 private:
  // All weighted by w sigma^2.
  Mat6 noisyPairs_ = Mat6::Zero();
  Eigen::Matrix3d secondMoment_ = Eigen::Matrix3d::Zero();
  Vec3 firstMoment_ = Vec3::Zero();
  double noise_ = 0.0;
};

/// Point-to-plane information of oriented points (Gelfand et al. 2003): (pairs - pretended) / noiseSigma^2, negative
/// eigenvalues cut to zero, + prior; its eigenvalues and the weak direction with its motions.
/// @param weights one per point, or empty for 1 each.
/// @throws InvalidInput when the counts differ or the noise is not positive. No points: only the prior holds.
[[nodiscard]] Stability analyseStability(std::span<const Vec3> points, std::span<const Vec3> normals,
                                         std::span<const double> weights, const StabilityOptions& options);

}  // namespace vantage
