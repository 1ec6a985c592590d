#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Where a scan belongs.
struct ScanPose {
  std::string file;  ///< as it stands in the list
  Pose T_object_scanner = Pose::Identity();
};

/// Reads a Stanford .conf: `bmesh FILE tx ty tz qx qy qz qw`, which means p_object = R(q)^T p_scan + t with R(q) the
/// rotation matrix of the quaternion (x, y, z, w): its conjugate turns the point. Other records are skipped.
/// @param scale millimetres per unit of the translations; the scale of the range files (RangeGrid::scale).
/// @throws IoError when it cannot be read
/// @throws InvalidInput naming file, line and expectation for a bmesh record without seven finite numbers or with a
///         quaternion that is not near unit length, and for a file without any
[[nodiscard]] std::vector<ScanPose> readScanPoses(const std::string& path, double scale);

/// The pose of a range file: the record with its name, folders aside and with or without .ply. Nothing when there is
/// none.
[[nodiscard]] std::optional<Pose> findPose(const std::vector<ScanPose>& poses, const std::string& rangeFile);

}  // namespace vantage
