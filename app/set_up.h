#pragma once

#include <memory>
#include <string>

#include "acquisition/acquisition_state.h"
#include "base/progress.h"
#include "geometry/mesh.h"
#include "positional_space/scanner_images.h"
#include "scanner/profile.h"

namespace vantage {

/// What an operator chooses before the first scan.
struct SetUpChoice {
  std::string scanner;           ///< profile file
  std::string folder;            ///< where session, models and report go
  AcquisitionSettings settings;  ///< names the object
};
[[nodiscard]] bool operator==(const SetUpChoice& a, const SetUpChoice& b);

/// A set-up that is ready to scan. Immutable, shared.
struct SetUp {
  SetUpChoice choice;
  ProfileSource source;
  std::shared_ptr<const ScannerProfile> profile;
  std::shared_ptr<const Mesh> object;  ///< as it stands on the table; null for recorded scans
  std::shared_ptr<const ScannerImages> images;
  std::string notes;         ///< what was done to the object while reading it; empty for nothing
  double radius = 0.0;       ///< of the object about the table's axis [mm]
  double height = 0.0;       ///< of its highest point above the table [mm]
  double lowest = 0.0;       ///< of its lowest [mm]
  bool insideVolume = true;  ///< the object keeps to the viewing volume
};
using SharedSetUp = std::shared_ptr<const SetUp>;

/// Reads profile and object, puts the object on the table and gets the scanner's images.
/// @param cacheFolder where images are kept between runs; empty for nowhere.
/// @throws IoError, InvalidInput naming the file; Cancelled
[[nodiscard]] SharedSetUp prepareSetUp(const SetUpChoice& choice, const std::string& cacheFolder,
                                       const Progress& progress);

}  // namespace vantage
