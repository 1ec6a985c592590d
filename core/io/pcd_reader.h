#pragma once

#include "base/progress.h"
#include "io/grid_file.h"

namespace vantage {

/// Reads an organised PCD file (HEIGHT above 1): x, y, z and rgb of ascii, binary and binary_compressed ones. A
/// VIEWPOINT that is no identity is where the scanner stood.
/// @param anyPoints whether points without rows and columns will do: see readSamples
/// @throws InvalidInput naming file, place and expectation; Cancelled
[[nodiscard]] GridFile readPcd(const FileBytes& file, bool anyPoints, const Progress& progress = {});

}  // namespace vantage
