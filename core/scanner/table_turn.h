#pragma once

#include "scanner/profile.h"

namespace vantage {

/// How an operator gets from one position to another: by turning the table, and by tilting the scanner.
struct TableTurn {
  double angle = 0.0;  ///< of the table, counter-clockwise seen from above, the shorter way, in (-pi, pi] [rad]
  double tilt = 0.0;   ///< of the scanner; positive raises it so that it looks farther down [rad]
};

/// The scanner's poses are relative to the object: where the scanner goes round the object counter-clockwise, the table
/// turns clockwise.
/// @throws InvalidInput when the workspace has no such position.
[[nodiscard]] TableTurn turnBetween(const Workspace& workspace, int from, int to);

/// How far the table is turned from the first position when the scanner is there, counter-clockwise seen from above, in
/// (-pi, pi] [rad]. @throws InvalidInput for a workspace without positions
[[nodiscard]] double tableAngle(const Workspace& workspace, const Pose& T_table_scanner);

/// Where the scanner is: the middle of its light sources, in object coordinates [mm].
[[nodiscard]] Vec3 scannerPlace(const ScannerProfile& profile, const Pose& T_object_scanner);

/// The azimuth of that place as seen from above [rad], counter-clockwise from +x, in [-pi, pi].
[[nodiscard]] double azimuthOf(const ScannerProfile& profile, const Pose& T_object_scanner);

}  // namespace vantage
