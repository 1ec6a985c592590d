#pragma once

#include <span>

#include "base/progress.h"
#include "integration/consensus.h"
#include "integration/model.h"
#include "integration/vertex_colours.h"
#include "scanner/view.h"

namespace vantage {

/// Whether any of the views saw colours.
[[nodiscard]] bool haveColours(std::span<const View> views);

/// The colours of a published model, averaged as its positions are (see applyConsensus): every vertex has
///   sum_k w_k c_k / sum_k w_k,
/// rounded, where c_k is the colour of view k where its surface lies at the vertex, interpolated between the samples
/// around, and w_k is what view k counts there. Only views with colours count. Where none has a say a vertex has the
/// colour of its own sample, if that has one. Colours follow from scans and poses: they are stored nowhere else.
/// @param views by the model's provenance, with poses as the model has them
/// @throws InvalidInput when the provenance names no view or sample, or a view with colours lacks its mesh; Cancelled
[[nodiscard]] VertexColours colourVertices(const Model& model, std::span<const View> views,
                                           const ConsensusOptions& options, const Progress& progress = {});

}  // namespace vantage
