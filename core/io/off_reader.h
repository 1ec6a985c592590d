#pragma once

#include "io/file_bytes.h"
#include "io/polygon_soup.h"

namespace vantage {

/// Reads OFF in text form with any of the prefixes ST, C, N before OFF; one vertex and one face per line. What only
/// concerns one polygon (a vertex that does not exist, a coordinate that is no number) is left in the soup for the
/// repair to drop and count.
/// @throws InvalidInput naming file, line (or byte) and what was expected, when the file is damaged or something else
/// @throws Cancelled
[[nodiscard]] PolygonSoup readOffSoup(const FileBytes& file, const Progress& progress = {});

}  // namespace vantage
