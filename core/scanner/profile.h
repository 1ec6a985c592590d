#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "scanner/mechanics.h"
#include "scanner/ray_grid.h"
#include "scanner/table_calibration.h"
#include "scanner/workspace.h"

namespace vantage {

/// The cylinder about the z axis, standing on z = 0, that the object fits in.
struct ViewingVolume {
  double radius = 150.0;  ///< [mm]
  double height = 300.0;  ///< [mm]
};

/// Measurement errors of the simulated scanner.
struct RangeNoise {
  double rangeSigma = 0.0;  ///< along the ray [mm]
  double dropout = 0.0;     ///< share of samples lost, 0..1
};

enum class PositionalSpaceSurface { Cylinder, Sphere };

/// How finely positional space is divided.
struct PositionalSpaceSize {
  PositionalSpaceSurface surface = PositionalSpaceSurface::Cylinder;
  int rows = 20;
  int columns = 90;
};

/// A scanner and where it can stand.
struct ScannerProfile {
  std::string name;
  std::string type;                     ///< as in the file: "rotating_stripe", ...
  std::shared_ptr<const RayGrid> rays;  ///< the scanner, at its identity pose
  double breakdownAngle = radians(60.0);
  double minRange = 0.0;  ///< [mm]
  double maxRange = 1e9;  ///< [mm]
  RangeNoise noise;
  Workspace workspace;
  ViewingVolume viewingVolume;
  PositionalSpaceSize positionalSpace;
  Mechanics mechanics;
  std::optional<TableCalibration> calibration;  ///< of the table; the workspace's poses are as it says
};

/// A profile as it was read: its text, and the texts of the files that it names, by the names it uses.
struct ProfileSource {
  std::string path;
  std::string text;
  std::map<std::string, std::string> attachments;
};

/// Reads a profile file and the files it names (resolved relative to it).
/// @throws IoError when one cannot be read or is larger than a profile can be; InvalidInput when the profile is so far
/// from one that the names cannot be found.
[[nodiscard]] ProfileSource readProfileSource(const std::string& path);

/// Checks and builds a profile. Unknown fields are errors.
/// @throws InvalidInput that names file, JSON pointer, value and what was expected.
[[nodiscard]] ScannerProfile parseProfile(const ProfileSource& source);

/// Both.
[[nodiscard]] ScannerProfile loadProfile(const std::string& path);

}  // namespace vantage
