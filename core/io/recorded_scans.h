#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/scan_reader.h"

namespace vantage {

/// Range files that were recorded elsewhere, and what is known of where.
struct RecordedScans {
  std::vector<std::string> files;
  std::string poses;                          ///< Stanford .conf; empty for none
  std::vector<std::optional<int>> positions;  ///< of a profile's workspace, per file; empty: of none it is known
  ScanReadingOptions reading;
};

/// Their scans, with the poses that the list, their positions or they themselves give them.
/// @param profile of their scanner; null: rays are reconstructed from the grids
/// @throws InvalidInput for positions without a profile, beside a list of poses, of another number than files, or that
/// the workspace does not have; as readScans
[[nodiscard]] std::vector<ReadScan> readRecordedScans(const RecordedScans& recorded, const ScannerProfile* profile,
                                                      const Progress& progress = {});

/// Scans of a scanner with a profile are in the unit that puts them on its rays: one that nobody said is asked for, not
/// guessed. @throws InvalidInput naming the file, the unit and the option
void requireSaidUnit(const std::vector<std::string>& files, const std::vector<ReadScan>& scans);

/// What each scan is called: its file, with a number where one file is several scans.
[[nodiscard]] std::vector<std::string> labelsOf(const std::vector<std::string>& files,
                                                const std::vector<ReadScan>& scans);

}  // namespace vantage
