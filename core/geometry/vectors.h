#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace vantage {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// A rigid motion. Variables name the frames, target first: `T_object_scanner` maps scanner to object coordinates.
using Pose = Eigen::Isometry3d;

/// A 6-vector of a small rigid motion: rotation [rad] first, then translation [mm].
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

inline constexpr double kPi = std::numbers::pi;
[[nodiscard]] constexpr double radians(double degrees) {
  return degrees * kPi / 180.0;
}
[[nodiscard]] constexpr double degrees(double radians) {
  return radians * 180.0 / kPi;
}

/// The pose exp(x): rotation by |x.head<3>()| about its direction, then translation by x.tail<3>().
[[nodiscard]] inline Pose smallMotion(const Vec6& x) {
  Pose pose = Pose::Identity();
  const Vec3 rotation = x.head<3>();
  const double angle = rotation.norm();
  if (angle > 0.0) pose.linear() = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
  pose.translation() = x.tail<3>();
  return pose;
}

}  // namespace vantage
