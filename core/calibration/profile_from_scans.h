#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/progress.h"
#include "calibration/sample_end.h"
#include "scanner/profile.h"
#include "scanner/range_image.h"

namespace vantage {

struct ProfileFitOptions {
  std::string name = "Scanner from scans";
  std::optional<Vec3> receiver;      ///< [right, up, forward] from the head [mm]; nothing: no triangulation
  int steps = 90;                    ///< positions of the turntable
  std::string rayFile = "rays.csv";  ///< name of the ray table, where one is needed
  double mostOff = 1.0;              ///< of samples from the rays of a camera; farther: a ray table [mm]
};

/// A scanner as its scans show it.
struct ProfileFit {
  ProfileSource source;           ///< its text, and the ray table that it may name
  std::string type;               ///< "pinhole", "rays"
  double residual = 0.0;          ///< root mean square distance of samples from their rays [mm]
  double noise = 0.0;             ///< of the samples along their rays, one sigma [mm]
  bool noiseFromRepeats = false;  ///< from scans of the same; else from how samples scatter on even patches
  double breakdownAngle = 0.0;    ///< where samples end, to a degree [rad]
  SampleEnd end;                  ///< the same with what it lies between
  double nearest = 0.0;           ///< of the samples [mm]
  double farthest = 0.0;          ///< [mm]
};

/// Describes the scanner of some scans as a profile that parseProfile takes: the rays of a depth camera where they fit,
/// in the frame of the scans, or before the table where the scans are in the frame of a camera at their origin; else a
/// table of rays. Noise, breakdown angle and range limits are those of the samples. Nothing tells where the table is:
/// that is for a calibration to say.
/// @param scans of one grid, of surfaces at different depths, in scanner coordinates; their rays are not used but for
///        where they look
/// @throws InvalidInput when there are none, they are of different grids, have too few samples or fit no smooth rays;
/// Cancelled
[[nodiscard]] ProfileFit profileFromScans(std::span<const RangeImage> scans, const ProfileFitOptions& options,
                                          const Progress& progress = {});

}  // namespace vantage
