#pragma once

#include "base/progress.h"
#include "io/grid_file.h"

namespace vantage {

/// Reads an organised PCD file (HEIGHT above 1): x, y and z of ascii, binary and binary_compressed ones. A VIEWPOINT
/// that is no identity is where the scanner stood.
/// @throws InvalidInput naming file, place and expectation; Cancelled
[[nodiscard]] GridFile readPcd(const FileBytes& file, const Progress& progress = {});

}  // namespace vantage
