#pragma once

#include <optional>

#include "base/progress.h"
#include "io/grid_file.h"

namespace vantage {

/// Points as text, a line each (XYZ, ASC, PTS, CSV): x y z, then anything, or colours as three whole numbers up to 255,
/// or an intensity and colours. Fields are divided by blanks, semicolons or commas; with blanks or semicolons the
/// decimal sign may be a comma. Lines that begin with # or //, and a few of words at the beginning, are skipped.
/// A first line of two whole numbers is columns and rows, in either order; of one, the number of points. Without it
/// rows and columns are those of `size`, or told by the order of the points where that is unambiguous (see
/// recogniseGrid); else the points are unorganised. nan, 0 0 0 and -9999 are cells without a sample.
/// @throws InvalidInput naming file, line and expectation, also for a file that ends early; Cancelled
[[nodiscard]] GridFile readTextPoints(const FileBytes& file, const std::optional<GridSize>& size,
                                      const Progress& progress = {});

/// The rows and columns that points lie in, a row after the other, as the distances from row to row tell: nothing where
/// no division of their number is clearly better than all others.
[[nodiscard]] std::optional<GridSize> recogniseGrid(const std::vector<Vec3>& points);

}  // namespace vantage
