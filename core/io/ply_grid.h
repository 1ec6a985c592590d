#pragma once

#include "base/progress.h"
#include "io/grid_file.h"
#include "io/ply_header.h"

namespace vantage {

/// Whether a PLY file has rows and columns of samples: an element range_grid, or, without faces, as many vertices as
/// its obj_info lines num_cols and num_rows say.
[[nodiscard]] bool isPlyGrid(const PlyHeader& header);

/// A PLY range file, see readGridFile. Colours of vertices are kept.
/// @param anyPoints whether vertices without rows and columns will do: see readSamples
/// @throws InvalidInput, Cancelled
[[nodiscard]] GridFile readPlyGrid(const FileBytes& file, bool anyPoints, const Progress& progress = {});

}  // namespace vantage
