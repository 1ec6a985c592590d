#include "scanner/workspace.h"

#include <algorithm>

namespace vantage {

Workspace turntable(int steps) {
  return turntableWithTilt(steps, {0.0}, Vec3::Zero());
}

Workspace turntableWithTilt(int steps, const std::vector<double>& tilts, const Vec3& tiltCentre) {
  Workspace workspace;
  workspace.steps = steps;
  for (const double tilt : tilts) {
    Pose raised = Pose::Identity();
    if (tilt != 0.0) {
      raised.translate(tiltCentre);
      raised.rotate(Eigen::AngleAxisd(-tilt, Vec3::UnitY()));
      raised.translate(-tiltCentre);
    }
    for (int i = 0; i < steps; ++i) {
      Pose turn = Pose::Identity();
      if (i > 0) turn.rotate(Eigen::AngleAxisd(2.0 * kPi * i / steps, Vec3::UnitZ()));
      workspace.poses.push_back(turn * raised);
    }
  }
  return workspace;
}

double motionBetween(const Workspace& workspace, int from, int to) {
  const std::size_t steps = static_cast<std::size_t>(workspace.steps);
  const auto a = static_cast<std::size_t>(from);
  const auto b = static_cast<std::size_t>(to);
  if (steps > 0) {
    const std::size_t apart = (b % steps + steps - a % steps) % steps;
    const double turn = 2.0 * kPi * static_cast<double>(std::min(apart, steps - apart)) / static_cast<double>(steps);
    const Pose tilt = workspace.poses[a - a % steps].inverse() * workspace.poses[b - b % steps];
    return turn + Eigen::AngleAxisd(tilt.linear()).angle();
  }
  const Pose motion = workspace.poses[a].inverse() * workspace.poses[b];
  return Eigen::AngleAxisd(motion.linear()).angle() + motion.translation().norm() / 100.0;
}

}  // namespace vantage
