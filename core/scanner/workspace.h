#pragma once

#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// The workspace X: every pose x_i that the scanner can take relative to the table, T_table_scanner, by position. x_0
/// is the identity for turntables that are not calibrated: the table's frame, which turns with it, is the scanner's
/// frame at position 0. How the object stands on the table is another matter, see Stand.
struct Workspace {
  std::vector<Pose> poses;
  /// Turntable positions per full turn; poses i and i + 1 of one tilt differ by a turn of 2 pi / steps about z. 0 when
  /// the poses have no such order.
  int steps = 0;
  /// C: where a calibration has the scanner against where the profile has it, the last factor of every pose. Identity
  /// without one.
  Pose T_table_scanner0 = Pose::Identity();

  [[nodiscard]] std::size_t size() const { return poses.size(); }
};

/// A turntable of `steps` positions.
[[nodiscard]] Workspace turntable(int steps);

/// A turntable with a scanner that tilts about `tiltCentre`; a positive tilt [rad] raises the scanner so that it looks
/// down. Positions run tilt by tilt, then step by step.
[[nodiscard]] Workspace turntableWithTilt(int steps, const std::vector<double>& tilts, const Vec3& tiltCentre);

/// How far the mechanics move between two positions: the rotation angle between the poses [rad] plus their translation
/// that the rotation about the table's axis does not explain, per 100 mm. Used to break ties.
[[nodiscard]] double motionBetween(const Workspace& workspace, int from, int to);

}  // namespace vantage
