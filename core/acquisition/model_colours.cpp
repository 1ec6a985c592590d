#include "acquisition/model_colours.h"

namespace vantage {

VertexColours coloursOf(const AcquisitionState& state, const Progress& progress) {
  if (!state.model) return {};
  return colourVertices(*state.model, viewsOf(state), state.settings.consensus, progress);
}

}  // namespace vantage
