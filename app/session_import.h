#pragma once

#include <string>

#include "io/recorded_scans.h"
#include "session_start.h"

namespace vantage {

/// What an operator says about scans that were recorded elsewhere.
struct ImportChoice {
  RecordedScans recorded;
  std::string scanner;           ///< profile file; empty: rays are found from the grids
  std::string folder;            ///< where session, models and report go
  AcquisitionSettings settings;  ///< of how they are worked on
};

/// Makes a session of recorded scans in its folder, under a name that is still free: registered and integrated. What
/// fails leaves nothing behind.
/// @throws as readRecordedScans, Session::create and Acquisition::importScans
[[nodiscard]] OpenedSession importSession(const ImportChoice& choice, const std::string& cacheFolder,
                                          const Progress& progress);

/// Adds scans of files to a session, each from its position, one after the other.
/// @param recorded with a position for every file. @throws InvalidInput without one; as readScanAt and
/// Acquisition::addScan: what was added before stays
void addRecordedScans(Acquisition& acquisition, const RecordedScans& recorded, const SetUp& setUp,
                      const Progress& progress);

}  // namespace vantage
