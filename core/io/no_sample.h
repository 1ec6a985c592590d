#pragma once

#include <optional>

#include "base/progress.h"
#include "io/range_grid_rays.h"
#include "scanner/scan_reading.h"

namespace vantage {

/// What was found where nothing had been measured.
struct NoSamples {
  NoSampleMark mark = NoSampleMark::None;
  std::size_t dropped = 0;  ///< cells that were left out
};

/// Leaves out the cells of a grid whose points say that nothing was measured: the point `given` (all coordinates, or z
/// alone, equal it), the point (0, 0, 0), a point that many cells share, a constant depth behind or before everything
/// else, and numbers out of all proportion to the rest. Two lines of sight never measure the same point, so a point
/// that repeats is none. A constant depth is real surface unless the rest shows noise that it has not, or lies far from
/// it. Where several marks are found, the one of most cells is named.
/// @throws Cancelled
[[nodiscard]] NoSamples dropNoSamples(SampleGrid& grid, std::optional<double> given, const Progress& progress = {});

}  // namespace vantage
