#include "registration/pair_term.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// A motion counts as measured when its information exceeds what the normals' noise pretends by more than that is
// uncertain: the noise of evened-out normals is shared by so many neighbours.
constexpr double kSharedBy = 19.0;
constexpr double kCertainty = 5.0;
constexpr double kLeastExcess = 0.25;

double measuredFactor(double pairs) {
  return 1.0 + std::clamp(kCertainty * std::sqrt(2.0 * kSharedBy / std::max(pairs, 1.0)), kLeastExcess, 1.0);
}

// The mean of two normals that differ by d across two directions has variance |d|^2 / 8 in each.
double normalSigma(const Pair& pair) {
  return std::sqrt(pair.normalSpread / 8.0);
}

// Robust scale while the gate shrinks.
constexpr double kScaleOfGate = 1.0 / 3.0;

}  // namespace

PairNoise pairNoise(double sigma, double gate, double finalGate) {
  return {sigma, gate > finalGate ? std::max(3.0 * sigma, kScaleOfGate * gate) : 3.0 * sigma};
}

PairTerm pairTerm(std::span<const Pair> pairs, const Pose& T_object_view, const Vec3& centre, double radius,
                  const PairNoise& noise) {
  MotionSums sums;
  Vec6 pull = Vec6::Zero();
  double count = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state != PairState::Paired) continue;
    const double w = pair.weight * robustWeight(pair.distance, noise.robustScale) / (noise.sigma * noise.sigma);
    const Vec3 d = T_object_view * pair.point - centre;
    const Vec3 n = T_object_view.linear() * pair.normal;
    sums.add(d, n, w, normalSigma(pair));
    ++count;
    Vec6 j;
    j << d.cross(n), n;
    pull += (w * pair.distance) * j;
  }
  PairTerm term;
  if (sums.weight <= 0.0) return term;

  Vec6 scale;
  scale << Vec3::Constant(1.0 / radius), Vec3::Ones();
  const Mat6 toMotion = scale.asDiagonal();
  const Mat6 toScaled = scale.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(Mat6(toMotion * sums.pairs * toMotion));
  const Mat6 pretended = toMotion * sums.pretended() * toMotion;
  const double measured = measuredFactor(count);
  for (int k = 0; k < 6; ++k) {
    const Vec6 v = solver.eigenvectors().col(k);
    const double information = solver.eigenvalues()[k];
    if (information <= std::max(0.0, measured * v.dot(pretended * v))) {
      ++term.leftOut;
      continue;
    }
    term.information += information * (toScaled * v) * (toScaled * v).transpose();
    term.pull += v.dot(toMotion * pull) * (toScaled * v);
  }
  return term;
}

Extent extentOf(std::span<const Pair> pairs, const Pose& T_object_view) {
  Vec3 sum = Vec3::Zero();
  double squares = 0.0;
  double count = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state != PairState::Paired) continue;
    sum += pair.point;
    count += 1.0;
  }
  if (count == 0.0) return {};
  const Vec3 centre = sum / count;
  for (const Pair& pair : pairs)
    if (pair.state == PairState::Paired) squares += (pair.point - centre).squaredNorm();
  return {T_object_view * centre, std::max(std::sqrt(squares / count), 1e-6)};
}

void PairStability::add(std::span<const Pair> pairs, const Pose& T_object_view) {
  for (const Pair& pair : pairs) {
    if (pair.state != PairState::Paired) continue;
    points_.push_back(T_object_view * pair.point);
    normals_.push_back(T_object_view.linear() * pair.normal);
    weights_.push_back(pair.weight);
    normalSigmas_.push_back(normalSigma(pair));
  }
}

Stability PairStability::analyse(double noiseSigma) const {
  StabilityOptions options;
  options.noiseSigma = noiseSigma;
  options.normalSigmas = normalSigmas_;
  return analyseStability(points_, normals_, weights_, options);
}

}  // namespace vantage
