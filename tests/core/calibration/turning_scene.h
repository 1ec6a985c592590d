#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "calibration/table_calibrator.h"
#include "geometry/mesh.h"
#include "scanner/profile.h"

namespace vantage::testing {

/// A depth camera that looks down at a table, 40 x 30 degrees.
[[nodiscard]] std::shared_ptr<const ScannerProfile> cameraOverTable(double rangeSigma = 0.1);

/// The stripe scanner of the resources, with half as many rays each way; it does not see the table top.
[[nodiscard]] std::shared_ptr<const ScannerProfile> stripeScanner();

/// An object on a table that turns otherwise than it counts, before a scanner that is elsewhere than its profile says.
struct TurningScene {
  Mesh object;  ///< table coordinates at angle 0
  std::shared_ptr<const ScannerProfile> profile;
  Pose T_table_scanner = Pose::Identity();  ///< where the scanner really is
  double tableRadius = 150.0;               ///< of the table top; 0: none [mm]
  bool wall = false;                        ///< behind the table, and a post beside it
  double turnsPerCount = 1.0;               ///< negative: it turns the other way
  double angleSigma = 0.0;                  ///< of every stand of the table [rad]
  std::optional<std::size_t> slipsBefore;   ///< this scan
  double slip = radians(-8.0);              ///< by so much [rad]
  std::uint64_t seed = 1;

  [[nodiscard]] std::vector<CalibrationScan> scans(std::span<const double> tableAngles) const;
};

/// How far a calibration is from the truth.
struct AxisError {
  double direction = 0.0;  ///< [deg]
  double place = 0.0;      ///< at a height above the table [mm]
  double plane = 0.0;      ///< how far the table plane is off at the axis [mm]
};
[[nodiscard]] AxisError errorOf(const TableCalibration& calibration, const Pose& T_table_scanner, double height);

/// A scanner that is off by millimetres and degrees about a point.
[[nodiscard]] Pose offBy(const Vec3& shift, const Vec3& turnDegrees, const Vec3& about);

/// An irregular lump that stands on the table beside its middle, of about 60 mm.
[[nodiscard]] Mesh makeLump();

/// A surface of revolution about the axis with a handle.
[[nodiscard]] Mesh makeCup();

/// A closed upright cylinder about an axis at x.
[[nodiscard]] Mesh makeCylinder(double radius, double height, double x);

}  // namespace vantage::testing
