#pragma once

#include <cstdint>

#include "io/file_bytes.h"
#include "io/polygon_soup.h"

namespace vantage {

/// Reads 3MF: the objects of the build, with their components, transformed and in millimetres. Materials, slices, beams
/// and other extensions are skipped; a file that requires an unknown extension is refused. What only concerns one
/// polygon (a vertex that does not exist, a coordinate that is no number) is left in the soup for the repair to drop
/// and count.
/// @param maxUnpacked limit of what the archive may unpack to [bytes].
/// @throws InvalidInput naming file, line (or byte) and what was expected, when the file is damaged or something else
/// @throws Cancelled
[[nodiscard]] PolygonSoup readThreeMfSoup(const FileBytes& file, std::uintmax_t maxUnpacked,
                                          const Progress& progress = {});

}  // namespace vantage
