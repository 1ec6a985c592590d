#pragma once

#include "io/file_bytes.h"
#include "io/polygon_soup.h"

namespace vantage {

/// Reads STL, binary or ASCII (told by size and content, not by the word solid). Binary: the size must be the one that
/// its triangle count asks for. ASCII: every solid must be closed by endsolid, else the file is truncated. What only
/// concerns one polygon (a vertex that does not exist, a coordinate that is no number) is left in the soup for the
/// repair to drop and count.
/// @throws InvalidInput naming file, line (or byte) and what was expected, when the file is damaged or something else
/// @throws Cancelled
[[nodiscard]] PolygonSoup readStlSoup(const FileBytes& file, const Progress& progress = {});

}  // namespace vantage
