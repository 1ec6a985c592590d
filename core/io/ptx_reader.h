#pragma once

#include "base/progress.h"
#include "io/grid_file.h"

namespace vantage {

/// Reads a PTX file with one scan: columns, rows, the scanner's place, a matrix of four lines that takes points (x y z
/// 1, as rows) to the world, then a point per cell, column by column; 0 0 0 is no sample.
/// @throws InvalidInput naming file, place and expectation, also for several scans in one file; Cancelled
[[nodiscard]] GridFile readPtx(const FileBytes& file, const Progress& progress = {});

}  // namespace vantage
