#pragma once

#include <cstdint>
#include <string_view>

#include "geometry/vectors.h"

namespace vantage {

/// What a calibration is worth.
enum class CalibrationVerdict : std::uint8_t { Good, Doubtful, Failed };

/// Where a table is before a scanner, and how it turns. Scanner coordinates are those of the profile's rays [mm].
struct TableCalibration {
  Vec3 axisPoint = Vec3::Zero();       ///< on the table's axis
  Vec3 axisDirection = Vec3::UnitZ();  ///< of length 1, away from the table plane to the side of the object
  double sigma = 0.0;                  ///< of the axis, at the height of what was scanned [mm]
  double angleSigma = 0.0;             ///< of its direction [rad]
  Vec3 planeNormal = Vec3::UnitZ();    ///< of the table top, of length 1, to the side of the object
  double planeOffset = 0.0;            ///< planeNormal . x + planeOffset = 0 on the table top [mm]
  int sense = 1;                       ///< 1: the table counts upwards when it turns counter-clockwise seen from above
  double degreesPerCommandedDegree = 1.0;
  double residual = 0.0;  ///< root mean square of what the scans do not fit the axis [mm]
  CalibrationVerdict verdict = CalibrationVerdict::Good;
};

/// "good", "doubtful", "failed".
[[nodiscard]] std::string_view name(CalibrationVerdict verdict);

/// Where the axis meets the table plane, scanner coordinates [mm]. @pre the axis is not parallel to the plane
[[nodiscard]] Vec3 tableCentre(const TableCalibration& calibration);

/// T_table_scanner at position 0: makes the axis the z axis and the place where it meets the table plane the origin, by
/// the smallest rotation. @pre the axis is not parallel to the plane
[[nodiscard]] Pose tablePose(const TableCalibration& calibration);

}  // namespace vantage
