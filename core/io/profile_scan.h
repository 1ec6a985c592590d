#pragma once

#include <optional>
#include <string>

#include "base/errors.h"
#include "base/progress.h"
#include "io/scan_evidence.h"
#include "io/scan_reader.h"
#include "scanner/profile.h"
#include "scanner/range_image.h"

namespace vantage {

/// A file that can be read once somebody says its unit or its frame: the message names the option.
class UnansweredQuestion : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// Reads a range file of any kind (see readSamples) that the scanner of a profile took, and puts its samples on the
/// rays of the profile. Where options and file do not say in which unit and frame the points are (of the profile, of a
/// camera that looks along z, of one that looks along -z, of the table, or of a head whose pose the file has), the rays
/// tell: in one of them the points lie on the rays. A unit other than millimetres that is only found so is asked for.
/// Colours are kept. Pose and station of the image are those of an empty one.
/// @param T_table_scanner where it was taken, if that is known: for points in the frame of the table
/// @throws IoError, InvalidInput as readSamples; InvalidInput where the points are not of this scanner;
///         UnansweredQuestion; Cancelled
[[nodiscard]] RangeImage readScan(const std::string& path, const ScannerProfile& profile,
                                  const ScanReadingOptions& options = {}, const Progress& progress = {},
                                  const std::optional<Pose>& T_table_scanner = {});

/// The samples of a file, of any organisation, on the rays of a profile, with the unit and frame that puts them there.
/// @param ownSize whether its rows and columns are those of the scanner: then they must lie on the rays exactly
/// @throws InvalidInput, UnansweredQuestion as readScan but for the unit, which is only said in the reading; Cancelled
[[nodiscard]] ReadScan placeOnRays(const RawScan& scan, const ScannerProfile& profile,
                                   const ScanReadingOptions& options, const std::optional<Pose>& T_table_scanner,
                                   bool ownSize, const Progress& progress = {});

}  // namespace vantage
