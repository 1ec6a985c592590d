#include "scanner/table_turn.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

// As it would be without a calibration, which may have the scanner's axes anywhere.
Eigen::Matrix3d rotationOf(const Workspace& workspace, const Pose& T_table_scanner) {
  return T_table_scanner.linear() * workspace.T_table_scanner0.linear().transpose();
}

Eigen::Matrix3d rotationAt(const Workspace& workspace, int position) {
  if (position < 0 || position >= static_cast<int>(workspace.size()))
    throw InvalidInput("there is no position " + std::to_string(position) + ", the workspace has " +
                       std::to_string(workspace.size()));
  return rotationOf(workspace, workspace.poses[static_cast<std::size_t>(position)]);
}

// A tilt turns about the scanner's y axis, so that axis tells the turn alone; the place of the scanner tells it only
// when that is on its x axis.
double turnOf(const Eigen::Matrix3d& rotation) {
  const Vec3 y = rotation.col(1);
  return std::atan2(y.y(), y.x());
}

// The scanner looks along -x: when it looks down, its x axis rises.
double tilt(const Eigen::Matrix3d& rotation) {
  return std::asin(std::clamp(rotation(2, 0), -1.0, 1.0));
}

// From one rotation to another, the shorter way.
double angleBetween(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const double angle = std::remainder(turnOf(from) - turnOf(to), 2.0 * kPi);
  return angle <= -kPi + 1e-12 ? kPi : angle;
}

}  // namespace

TableTurn turnBetween(const Workspace& workspace, int from, int to) {
  const Eigen::Matrix3d a = rotationAt(workspace, from);
  const Eigen::Matrix3d b = rotationAt(workspace, to);
  return {angleBetween(a, b), tilt(b) - tilt(a)};
}

double tableAngle(const Workspace& workspace, const Pose& T_table_scanner) {
  return angleBetween(rotationAt(workspace, 0), rotationOf(workspace, T_table_scanner));
}

Vec3 scannerPlace(const ScannerProfile& profile, const Pose& T_object_scanner) {
  const RayGrid& rays = *profile.rays;
  return T_object_scanner * rays.rayAt({0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)}).origin;
}

double azimuthOf(const ScannerProfile& profile, const Pose& T_object_scanner) {
  const Vec3 place = scannerPlace(profile, T_object_scanner);
  return std::atan2(place.y(), place.x());
}

}  // namespace vantage
