#pragma once

#include <string>

#include "base/progress.h"
#include "integration/model.h"
#include "io/ply_header.h"

namespace vantage {

/// A model as exportModel() writes it to PLY: with the vertex property `confidence` and the face property `view`. Which
/// sample a vertex was does not stand in the file: vertexView and vertexSample are kNoIndex. Nothing is repaired;
/// binary files with float coordinates are copied without detours.
/// @throws IoError when it cannot be read
/// @throws InvalidInput naming file, place and expectation: also when one of the two properties is missing or not
///         possible, for faces other than triangles, vertices that do not exist and coordinates that are not finite
/// @throws Cancelled
[[nodiscard]] Model readModel(const std::string& path, const Progress& progress = {});

/// Whether a PLY file with that header holds a model (and not just any mesh).
[[nodiscard]] bool isModel(const PlyHeader& header);

}  // namespace vantage
