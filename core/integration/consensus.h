#pragma once

#include <span>

#include "base/progress.h"
#include "integration/model.h"
#include "scanner/view.h"

namespace vantage {

struct ConsensusOptions {
  /// A view's surface farther than this along the vertex's normal is another surface [mm]; or than
  double maxOffset = 0.6;
  /// this many of the view's sample spacings, whichever is more. Its say fades towards the limit.
  double spacingOffset = 0.8;
  /// Nor does it count when the normals enclose more than this [rad].
  double normalTolerance = radians(60.0);
  int passes = 1;
};

/// The published geometry (Turk & Levoy 1994, 4): every vertex moves along its normal n to
///   p + n sum_k w_k s_k / sum_k w_k,
/// where s_k is where the line p + s n meets the surface of view k and w_k is the view's confidence there, which
/// fades towards the border of the view and towards the offset limit. Topology and provenance stay; a vertex's
/// confidence becomes the best among the views that have a say. Vertices that no view meets stay where they are.
/// @throws InvalidInput when a view has no mesh, Cancelled
[[nodiscard]] Model applyConsensus(const Model& model, std::span<const View> views, const ConsensusOptions& options,
                                   const Progress& progress = {});

}  // namespace vantage
