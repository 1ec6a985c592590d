#include "scanner/table_calibration.h"

namespace vantage {

std::string_view name(CalibrationVerdict verdict) {
  switch (verdict) {
    case CalibrationVerdict::Good:
      return "good";
    case CalibrationVerdict::Doubtful:
      return "doubtful";
    case CalibrationVerdict::Failed:
      break;
  }
  return "failed";
}

Vec3 tableCentre(const TableCalibration& calibration) {
  const double above = calibration.planeNormal.dot(calibration.axisPoint) + calibration.planeOffset;
  return calibration.axisPoint -
         above / calibration.planeNormal.dot(calibration.axisDirection) * calibration.axisDirection;
}

Pose tablePose(const TableCalibration& calibration) {
  Pose T_table_scanner = Pose::Identity();
  T_table_scanner.linear() =
      Eigen::Quaterniond::FromTwoVectors(calibration.axisDirection, Vec3::UnitZ()).toRotationMatrix();
  T_table_scanner.translation() = -(T_table_scanner.linear() * tableCentre(calibration));
  return T_table_scanner;
}

}  // namespace vantage
