#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "geometry/vectors.h"
#include "registration/oriented_points.h"

namespace vantage {

/// How sure the poses of several views are of each other, by what all pairs of all of them say.
class PoseCovariance {
 public:
  /// Poses that are not moved.
  PoseCovariance() = default;
  /// @param information 6 (n - 1) square, about the motions of all views but the first: rotation about `centre` times
  /// `radius`, then shift [1/mm^2]. @param loose what nothing holds has this sigma [mm]
  PoseCovariance(const Eigen::MatrixXd& information, const Vec3& centre, double radius, double loose);

  /// How far a view's points may be off against another view: one sigma of the weakest motion [mm]; 0 of the same view.
  /// @param points of the view, scanner coordinates. @param T_object_view its pose
  [[nodiscard]] double sigma(std::size_t view, std::size_t against, const OrientedVertices& points,
                             const Pose& T_object_view) const;

 private:
  [[nodiscard]] Mat6 block(std::size_t i, std::size_t j) const;

  Eigen::MatrixXd covariance_;
  Vec3 centre_ = Vec3::Zero();
  double radius_ = 1.0;
};

}  // namespace vantage
