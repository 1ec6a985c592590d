#include "registration/pose_covariance.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// How far a motion about a centre moves points at most [mm].
double farthestMotion(const Vec6& motion, const Vec3& centre, const OrientedVertices& points,
                      const Pose& T_object_view) {
  double farthest = points.size() == 0 ? 1.0 : 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 p = T_object_view * points.pointAt(k) - centre;
    farthest = std::max(farthest, (motion.head<3>().cross(p) + motion.tail<3>()).norm());
  }
  return farthest;
}

}  // namespace

PoseCovariance::PoseCovariance(const Eigen::MatrixXd& information, const Vec3& centre, double radius, double loose)
    : centre_(centre), radius_(radius) {
  Eigen::MatrixXd held = information;
  held.diagonal().array() += 1.0 / (loose * loose);
  covariance_ = held.llt().solve(Eigen::MatrixXd::Identity(held.rows(), held.cols()));
}

double PoseCovariance::sigma(std::size_t view, std::size_t against, const OrientedVertices& points,
                             const Pose& T_object_view) const {
  if (view == against) return 0.0;
  const Mat6 between = block(view, view) + block(against, against) - block(view, against) - block(against, view);
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(between);
  Vec6 weakest = solver.eigenvectors().col(5);
  weakest.head<3>() /= radius_;
  return farthestMotion(weakest, centre_, points, T_object_view) * std::sqrt(std::max(0.0, solver.eigenvalues()[5]));
}

// The first view stays: it has no part in the covariance.
Mat6 PoseCovariance::block(std::size_t i, std::size_t j) const {
  if (i == 0 || j == 0) return Mat6::Zero();
  return covariance_.block<6, 6>(static_cast<Eigen::Index>(6 * (i - 1)), static_cast<Eigen::Index>(6 * (j - 1)));
}

}  // namespace vantage
