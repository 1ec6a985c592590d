#pragma once

#include <vector>

#include "io/ply_document.h"
#include "scanner/range_image.h"

namespace vantage {

/// The colours of a PLY file's vertices, of which `red`, `green` and `blue` were selected; none where one of the three
/// is missing. Numbers with a fraction are shares of full light.
[[nodiscard]] std::vector<Colour> vertexColours(const PlyDocument& document);

}  // namespace vantage
