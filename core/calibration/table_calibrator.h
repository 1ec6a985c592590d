#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "calibration/calibration_finding.h"
#include "calibration/sample_motion.h"
#include "calibration/turn_search.h"
#include "scanner/profile.h"
#include "scanner/thinning.h"

namespace vantage {

/// How one scan fits the calibration.
struct ScanResidual {
  double tableAngle = 0.0;  ///< as the table counted [deg]
  double turned = 0.0;      ///< as it was found, about the axis, 0 in the first scan [rad]
  double off = 0.0;         ///< that, less what the table counted, made true by sense and ratio [rad]
  double rms = 0.0;         ///< of the pairs with all other scans [mm]
  std::size_t pairs = 0;
  std::size_t moving = 0;  ///< samples that move
  bool used = false;       ///< the scan shows enough of what turns
};

struct CalibrationOptions {
  ThinningOptions thinning;  ///< of the scans, as an acquisition thins them
  RatioRange ratio;
  double leastTurn = radians(20.0);    ///< of the table in all [rad]
  std::size_t leastSamples = 150;      ///< that move; scans with fewer are not used
  double unsure = 0.2;                 ///< sigma of the axis at the object; more: doubtful [mm]
  double unsureAngle = radians(0.15);  ///< and of its direction [rad]
  double notObservable = 1.0;          ///< sigma of the axis or, at 50 mm, of an angle; more: failed [mm]
  double mostMisfit = 0.4;             ///< failed [share]
  double leastRival = 1.6;             ///< a rival has at most so many times the misfit
  double planeLean = radians(1.0);     ///< doubtful [rad]
};

struct CalibrationResult {
  TableCalibration calibration;  ///< its verdict says what the other values are worth
  double planeSigma = 0.0;       ///< of the table plane at the axis [mm]
  bool planeSeen = false;        ///< else its height is a guess
  std::vector<ScanResidual> scans;
  std::vector<CalibrationFinding> findings;  ///< the gravest first
};

/// Finds where a turntable stands before a scanner, and how it turns, from 3 to 12 scans of any object on it at table
/// angles that are known as the table counts. What moves between the scans is the object; what does not is table top
/// and background and has no say about the turn. All ratios and both senses are tried from a rough axis, the profile's
/// or that of the table top; then axis and angles of all scans are fitted together (see fitScrew). What fails does so
/// with a verdict and findings, not with an exception. Of scanners of very many rays every n-th row and column is used.
/// @throws InvalidInput for another number of scans, and when they are not of one scanner; Cancelled
[[nodiscard]] CalibrationResult calibrateTable(std::span<const CalibrationScan> scans, const ScannerProfile& profile,
                                               const CalibrationOptions& options = {}, const Progress& progress = {});

}  // namespace vantage
