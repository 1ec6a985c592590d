#pragma once

#include <cstddef>
#include <memory>

#include "base/progress.h"
#include "registration/icp.h"
#include "scanner/mechanics.h"
#include "scanner/profile.h"
#include "scanner/rig.h"
#include "scanner/scan_cut.h"

namespace vantage {

/// What two scans told about a turntable: whether it turned as the profile says.
struct TestTurn {
  // Two moves, and what a scan tells of a place: a small part of a degree and of a millimetre.
  static constexpr double kSigmas = 3.3;
  static constexpr double kScanAngle = 0.001;  ///< sigma [rad]
  static constexpr double kScanOffset = 0.1;   ///< sigma [mm]

  double expected = 0.0;    ///< turn of the scanner about the object, counter-clockwise from above [rad]
  double measured = 0.0;    ///< the same as the scans were found [rad]
  double axisOffset = 0.0;  ///< how far the axis moved sideways between the scans [mm]
  std::size_t samples = 0;  ///< of the first scan that are used
  Mechanics errors;         ///< of one move, as the positioner or else the profile says them
  RegistrationResult registration;

  /// Whether turn and axis are where two moves with such errors leave them, in all but one of a thousand cases.
  [[nodiscard]] bool asExpected() const;
  /// How far off they may be: the turn [rad], and the axis [mm].
  [[nodiscard]] double angleLimit() const;
  [[nodiscard]] double offsetLimit() const;
};

/// Scans from two positions with a rig that is open, cuts both scans, and registers the second scan with the first.
/// Neither is kept. Steps reported: scan, register.
/// @throws InvalidInput when the first scan has no surface or the workspace lacks a position; DeviceError, Cancelled
[[nodiscard]] TestTurn testTurn(const Rig& rig, const ScannerProfile& profile, int from, int to, const CutOptions& cut,
                                const Progress& progress);

}  // namespace vantage
