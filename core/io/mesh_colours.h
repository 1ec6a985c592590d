#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "scanner/range_image.h"

namespace vantage {

/// The colours of the vertices of a mesh file, in the order of the file, before any repair: of PLY with the properties
/// red, green and blue, and of OBJ where every vertex has three shares of 1 after its coordinates. Empty for files
/// without, and for other formats.
/// @throws IoError when it cannot be read
/// @throws InvalidInput naming file and place when it is damaged
/// @throws Cancelled
[[nodiscard]] std::vector<Colour> readMeshColours(const std::string& path, const Progress& progress = {});

}  // namespace vantage
