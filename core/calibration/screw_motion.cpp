#include "calibration/screw_motion.h"

namespace vantage {

Pose ScrewMotion::pose(std::size_t scan) const {
  Pose turn = Pose::Identity();
  turn.translate(point);
  turn.rotate(Eigen::AngleAxisd(-angles[scan], direction));
  turn.translate(-point);
  return turn;
}

std::vector<Pose> ScrewMotion::poses() const {
  std::vector<Pose> result;
  for (std::size_t scan = 0; scan < angles.size(); ++scan) result.push_back(pose(scan));
  return result;
}

AcrossAxis::AcrossAxis(const Vec3& direction) : first(direction.unitOrthogonal()), second(direction.cross(first)) {}

}  // namespace vantage
