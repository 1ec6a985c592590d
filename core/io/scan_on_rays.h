#pragma once

#include <optional>

#include "io/scan_evidence.h"
#include "io/scan_reader.h"

namespace vantage {

/// A file that was taken with the rays of a profile. Its samples must lie on them: that tells its unit, whether rows
/// and columns are exchanged, and its frame, which is that of the profile, of a camera at the origin that looks along
/// z, or of the table. A file of other rows and columns, or of none, is put on the rays as placeOnRays does.
/// @param T_table_scanner where it was taken; becomes the pose of the image.
/// @param inUnits whether its translation is in units of the file, else in millimetres.
/// @throws InvalidInput when no unit and frame puts the samples on the rays: it is another scanner's file;
///         Cancelled
[[nodiscard]] ReadScan readOnRays(RawScan scan, const ScannerProfile& profile,
                                  const std::optional<Pose>& T_table_scanner, bool inUnits,
                                  const ScanReadingOptions& options, const Progress& progress);

}  // namespace vantage
