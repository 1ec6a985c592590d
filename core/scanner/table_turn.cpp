#include "scanner/table_turn.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

const Pose& poseAt(const Workspace& workspace, int position) {
  if (position < 0 || position >= static_cast<int>(workspace.size()))
    throw InvalidInput("there is no position " + std::to_string(position) + ", the workspace has " +
                       std::to_string(workspace.size()));
  return workspace.poses[static_cast<std::size_t>(position)];
}

// A tilt turns about the scanner's y axis, so that axis tells the turn alone.
double azimuth(const Pose& pose) {
  const Vec3 y = pose.linear().col(1);
  return std::atan2(y.y(), y.x());
}

// The scanner looks along -x: when it looks down, its x axis rises.
double tilt(const Pose& pose) {
  return std::asin(std::clamp(pose.linear()(2, 0), -1.0, 1.0));
}

}  // namespace

TableTurn turnBetween(const Workspace& workspace, int from, int to) {
  const Pose& a = poseAt(workspace, from);
  const Pose& b = poseAt(workspace, to);
  double angle = std::remainder(azimuth(a) - azimuth(b), 2.0 * kPi);
  if (angle <= -kPi + 1e-12) angle = kPi;
  return {angle, tilt(b) - tilt(a)};
}

}  // namespace vantage
