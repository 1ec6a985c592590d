#include "registration/motion_information.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "registration/weak_direction.h"

namespace vantage {
namespace {

void locateCentre(std::span<const Vec3> points, std::span<const double> weights, Stability& stability) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = weights.empty() ? 1.0 : weights[i];
    sum += w * points[i];
    total += w;
  }
  if (total <= 0.0) return;
  stability.centre = sum / total;
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    squares += (weights.empty() ? 1.0 : weights[i]) * (points[i] - stability.centre).squaredNorm();
  stability.radius = std::sqrt(squares / total);
}

// Noise can be overestimated; no direction is known less than not at all.
Mat6 withoutNegativeParts(const Mat6& information) {
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(information);
  const double rounding = 1e-12 * solver.eigenvalues().cwiseAbs().maxCoeff();
  const Vec6 kept = (solver.eigenvalues().array() > rounding).select(solver.eigenvalues(), 0.0);
  return solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
}

double farthestMotion(std::span<const Vec3> points, const Vec3& centre, const Vec6& motion) {
  const Vec3 turn = motion.head<3>();
  const Vec3 shift = motion.tail<3>();
  double farthest = points.empty() ? 1.0 : 0.0;
  for (const Vec3& p : points) farthest = std::max(farthest, (turn.cross(p - centre) + shift).norm());
  return farthest;
}

}  // namespace

void MotionSums::add(const Vec3& d, const Vec3& n, double w, double normalSigma) {
  Vec6 j;
  j << d.cross(n), n;
  const Mat6 product = (w * j) * j.transpose();
  const double variance = normalSigma * normalSigma;
  pairs += product;
  weight += w;
  noisyPairs_ += variance * product;
  secondMoment_.noalias() += (w * variance * d) * d.transpose();
  firstMoment_ += w * variance * d;
  noise_ += w * variance;
}

Mat6 MotionSums::pretended() const {
  // J = A n with A = ([d]x; 1), so the sum over three orthogonal normals is A A^T.
  Eigen::Matrix3d cross;
  cross << 0.0, -firstMoment_.z(), firstMoment_.y(), firstMoment_.z(), 0.0, -firstMoment_.x(), -firstMoment_.y(),
      firstMoment_.x(), 0.0;
  Mat6 all;
  all.topLeftCorner<3, 3>() = secondMoment_.trace() * Eigen::Matrix3d::Identity() - secondMoment_;
  all.topRightCorner<3, 3>() = cross;
  all.bottomLeftCorner<3, 3>() = -cross;
  all.bottomRightCorner<3, 3>() = noise_ * Eigen::Matrix3d::Identity();
  return all - noisyPairs_;
}

Stability analyseStability(std::span<const Vec3> points, std::span<const Vec3> normals, std::span<const double> weights,
                           const StabilityOptions& options) {
  const auto fits = [&](std::span<const double> values) { return values.empty() || values.size() == points.size(); };
  if (points.size() != normals.size() || !fits(weights) || !fits(options.normalSigmas))
    throw InvalidInput("stability needs one normal and one weight for every point");
  if (!(options.noiseSigma > 0.0)) throw InvalidInput("stability needs a positive noise");

  Stability stability;
  locateCentre(points, weights, stability);
  const double radius = stability.radius > 0.0 ? stability.radius : 1.0;
  MotionSums sums;
  for (std::size_t i = 0; i < points.size(); ++i)
    sums.add(points[i] - stability.centre, normals[i], weights.empty() ? 1.0 : weights[i],
             options.normalSigmas.empty() ? options.normalSigma : options.normalSigmas[i]);

  // y = (radius * rotation, translation) = scale^-1 x makes all six directions comparable.
  Vec6 scale;
  scale << Vec3::Constant(1.0 / radius), Vec3::Ones();
  const Mat6 toMotion = scale.asDiagonal();
  Mat6 scaled = toMotion * (sums.pairs - sums.pretended()) * toMotion;
  scaled = withoutNegativeParts(scaled) / (options.noiseSigma * options.noiseSigma);
  if (options.prior) scaled += toMotion * informationAbout(*options.prior, stability.centre) * toMotion;

  const Eigen::SelfAdjointEigenSolver<Mat6> solver(scaled);
  const double rounding = 1e-12 * std::max(solver.eigenvalues()[5], 0.0);
  stability.eigenvalues = (solver.eigenvalues().array() > rounding).select(solver.eigenvalues(), 0.0);
  const Mat6 toScaled = scale.cwiseInverse().asDiagonal();
  stability.information = toScaled * scaled * toScaled;
  const WeakDirection weak = weakestDirection(stability.eigenvalues, solver.eigenvectors());
  stability.weakDirection = toMotion * weak.direction;
  stability.weakMotions = weak.motions;
  const double least = stability.eigenvalues[0];
  const Vec6 weakest = toMotion * solver.eigenvectors().col(0);
  stability.poseSigma = least > 0.0 ? farthestMotion(points, stability.centre, weakest) / std::sqrt(least)
                                    : std::numeric_limits<double>::infinity();
  return stability;
}

}  // namespace vantage
