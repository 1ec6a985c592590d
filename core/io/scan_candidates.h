#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/grid_file.h"
#include "io/scan_reader.h"
#include "scanner/profile.h"
#include "scanner/scan_reading.h"

namespace vantage {

/// Coordinates that the points of a file may be in.
enum class ScanFrame : std::uint8_t {
  Profile,  ///< of the scanner's profile
  Camera,   ///< of its head: x right, y down, z forward
  OpenGl,   ///< of its head: x right, y up, z backward
  File,     ///< of its head, which the file itself places in the profile's
  Table,    ///< of the table that the object stands on
};

/// A unit and a frame that the points of a file may be in.
struct ScanCandidate {
  double unit = 1.0;  ///< millimetres per unit
  KnownBy unitKnownBy = KnownBy::Default;
  ScanFrame frame = ScanFrame::Profile;
  Pose T_scanner_file = Pose::Identity();  ///< of points in millimetres
};

/// Where the head of a scanner is in the frame of its profile: at the middle of its light sources, z where its middle
/// ray looks, x level and to the right as it sees it, y down.
[[nodiscard]] Pose headOf(const RayGrid& rays);

/// The units and frames that options, the file and the profile leave, the usual ones first.
/// @param T_table_scanner where it was taken, for points in the frame of the table
/// @throws InvalidInput for a frame that a scanner with a profile does not have
[[nodiscard]] std::vector<ScanCandidate> candidatesFor(const GridFile& file, const ScannerProfile& profile,
                                                       const ScanReadingOptions& options,
                                                       const std::optional<Pose>& T_table_scanner);

/// How samples lie on rays if a candidate is right, as some of them tell.
struct ScanScore {
  double reached = 0.0;   ///< share that the scanner can reach: in its grid of rays and its range
  double inVolume = 0.0;  ///< share about the viewing volume
  double aside = 1.0;     ///< median distance from the nearest ray [cells]
  double spread = 0.0;    ///< rays that have any of the samples, per sample

  /// The samples are of these rays.
  [[nodiscard]] bool isExact() const { return reached >= 0.9 && inVolume >= 0.02 && aside <= 0.15; }
  /// They may be samples that this scanner took with other rays, or that were thinned out or smoothed.
  [[nodiscard]] bool isLikely() const { return reached >= 0.95 && inVolume >= 0.3 && spread >= 0.1; }
};
[[nodiscard]] ScanScore scoreOf(const ScanCandidate& candidate, const std::vector<Vec3>& points,
                                const ScannerProfile& profile, const std::optional<Pose>& T_table_scanner);

}  // namespace vantage
