#pragma once

#include "geometry/vectors.h"
#include "scanner/profile.h"

namespace vantage {

/// What is known of a pose before looking at the surface: a normal distribution of the small motion away from the
/// nominal pose, T_found = motion * T_nominal, in object coordinates.
struct PosePrior {
  Mat6 information = Mat6::Zero();  ///< inverse covariance; rotation [rad] about `centre` first, then translation [mm]
  Vec3 centre = Vec3::Zero();       ///< that stays put when the motion is a pure rotation [mm]
};

/// The same sigma for every rotation [rad] about a point and every translation [mm].
/// @throws InvalidInput unless both are positive.
[[nodiscard]] PosePrior isotropicPrior(double rotationSigma, double translationSigma, const Vec3& centre);

/// What a turntable leaves open after a number of moves (at least 1) that each add an error: sigmas grow with the
/// square root of the moves. The degrees of freedom that a turntable does not have get 0.05 degrees and 0.05 mm, which
/// is also the least of the others.
[[nodiscard]] PosePrior turntablePrior(const Mechanics& mechanics, int moves = 1);

/// The rigid motion x (rotation [rad] about `centre`, then translation [mm]).
[[nodiscard]] Pose motionAbout(const Vec3& centre, const Vec6& x);

/// The inverse of motionAbout for rotations by less than pi.
[[nodiscard]] Vec6 motionVector(const Pose& motion, const Vec3& centre);

/// The matrix that turns the vector of a small motion about `from` into that of the same motion about `to`.
[[nodiscard]] Mat6 changeOfCentre(const Vec3& from, const Vec3& to);

/// The prior's information about motions around another centre.
[[nodiscard]] Mat6 informationAbout(const PosePrior& prior, const Vec3& centre);

}  // namespace vantage
