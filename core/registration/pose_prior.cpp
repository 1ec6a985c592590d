#include "registration/pose_prior.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kLeastAngle = radians(0.05);
constexpr double kLeastShift = 0.05;  // [mm]

Eigen::Matrix3d crossMatrix(const Vec3& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Mat6 diagonalInformation(const Vec6& sigma) {
  return sigma.cwiseAbs2().cwiseInverse().asDiagonal();
}

}  // namespace

PosePrior isotropicPrior(double rotationSigma, double translationSigma, const Vec3& centre) {
  if (!(rotationSigma > 0.0) || !(translationSigma > 0.0))
    throw InvalidInput("the sigmas of a pose prior must be positive");
  Vec6 sigma;
  sigma << Vec3::Constant(rotationSigma), Vec3::Constant(translationSigma);
  return {diagonalInformation(sigma), centre};
}

PosePrior turntablePrior(const Mechanics& mechanics, int moves) {
  const double growth = std::sqrt(std::max(moves, 1));
  const double angle = std::max(mechanics.angleSigma * growth, kLeastAngle);
  const double shift = std::max(mechanics.positionSigma * growth, kLeastShift);
  Vec6 sigma;
  sigma << kLeastAngle, kLeastAngle, angle, shift, shift, kLeastShift;
  return {diagonalInformation(sigma), Vec3::Zero()};
}

Pose motionAbout(const Vec3& centre, const Vec6& x) {
  Pose motion = smallMotion(x);
  motion.translation() = centre + x.tail<3>() - motion.linear() * centre;
  return motion;
}

Vec6 motionVector(const Pose& motion, const Vec3& centre) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(motion.linear()));
  Vec6 x;
  x << turn.angle() * turn.axis(), motion * centre - centre;
  return x;
}

Mat6 changeOfCentre(const Vec3& from, const Vec3& to) {
  Mat6 m = Mat6::Identity();
  // The point `to` moves by t + w x (to - from).
  m.bottomLeftCorner<3, 3>() = -crossMatrix(to - from);
  return m;
}

Mat6 informationAbout(const PosePrior& prior, const Vec3& centre) {
  const Mat6 toPrior = changeOfCentre(centre, prior.centre);
  return toPrior.transpose() * prior.information * toPrior;
}

}  // namespace vantage
