#include "registration/weak_direction.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

using Subspace = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// An axis farther from the points than this many radii makes a turn look like a slide.
constexpr double kFarAxis = 4.0;
// Eigenvalues within this factor of the smallest, or this small against the largest, are equally weak.
constexpr double kSameFactor = 2.0;
constexpr double kNothing = 1e-6;
// Share of a plain motion that must lie in the weak subspace for it to be one of its members.
constexpr double kMember = 0.97;
const double kSameAxis = std::cos(radians(10.0));

Vec3 plainAxis(Vec3 axis) {
  axis.normalize();
  int largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0.0) axis = -axis;
  if (axis[largest] >= kSameAxis) return Vec3::Unit(largest);
  // Adding zero turns -0.0 into 0.0.
  return (axis * 10.0).array().round() / 10.0 + 0.0;
}

WeakMotion slideAlong(const Vec3& axis) {
  return {WeakMotion::Kind::Slide, plainAxis(axis)};
}

WeakMotion turnAbout(const Vec3& axis) {
  return {WeakMotion::Kind::Turn, plainAxis(axis)};
}

// What is left of an orthonormal basis after taking out one of its members.
Subspace without(const Subspace& basis, const Vec6& member) {
  Subspace rest = basis - member * (member.transpose() * basis);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rest, Eigen::ComputeThinU);
  return svd.matrixU().leftCols(basis.cols() - 1);
}

// The plainest motions: slides along the axes, then turns about them (about any parallel axis, since the
// translation part of a turn depends on where the centre lies).
Subspace plainMotions() {
  Subspace plain = Subspace::Zero(6, 6);
  plain.bottomLeftCorner(3, 3).setIdentity();
  plain.topRightCorner(3, 3).setIdentity();
  return plain;
}

}  // namespace

std::string_view name(WeakMotion::Kind kind) {
  switch (kind) {
    case WeakMotion::Kind::Slide:
      return "slide";
    case WeakMotion::Kind::Turn:
      return "turn";
    case WeakMotion::Kind::Free:
      break;
  }
  return "free";
}

WeakMotion plainMotion(const Vec6& motion) {
  const Vec3 turn = motion.head<3>();
  const Vec3 shift = motion.tail<3>();
  const double angle = turn.norm();
  if (angle < 1e-9) return slideAlong(shift);
  const Vec3 axis = turn / angle;
  const double along = shift.dot(axis);
  const double axisDistance = (shift - along * axis).norm() / angle;  // in radii
  if (axisDistance > kFarAxis || std::abs(along) > angle) return slideAlong(shift);
  return turnAbout(axis);
}

WeakDirection weakestDirection(const Vec6& eigenvalues, const Mat6& eigenvectors) {
  if (eigenvalues[5] <= 0.0) return {eigenvectors.col(0), {WeakMotion{}}};
  const double limit = std::max(kSameFactor * eigenvalues[0], kNothing * eigenvalues[5]);
  int count = 1;
  while (count < 6 && eigenvalues[count] <= limit) ++count;
  const Vec6 weakest = eigenvectors.col(0);
  if (count == 1 || count > 3) return {weakest, {plainMotion(weakest)}};

  WeakDirection found;
  Subspace weak = eigenvectors.leftCols(count);
  auto take = [&](const Vec6& member) {
    if (found.motions.empty()) found.direction = member;
    found.motions.push_back(plainMotion(member));
    weak = without(weak, member);
  };
  const Subspace plain = plainMotions();
  for (int k = 0; k < 6 && weak.cols() > 0; ++k) {
    const Vec6 part = weak * (weak.transpose() * plain.col(k));
    if (part.norm() < 1e-3) continue;
    const bool slide = k < 3;
    const bool member = slide ? part.norm() >= kMember : plainMotion(part) == turnAbout(Vec3::Unit(k % 3));
    if (member) take(part.normalized());
  }
  while (weak.cols() > 0) take(weak.col(0));
  return found;
}

}  // namespace vantage
