#pragma once

#include "acquisition/acquisition_state.h"
#include "integration/colouring.h"

namespace vantage {

/// The colours of a state's model, see colourVertices; empty without a model, or where no scan of it has colours.
/// @throws Cancelled
[[nodiscard]] VertexColours coloursOf(const AcquisitionState& state, const Progress& progress = {});

}  // namespace vantage
