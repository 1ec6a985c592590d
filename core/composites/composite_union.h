#pragma once

#include "base/progress.h"
#include "composites/aligned_pose.h"
#include "integration/consensus.h"
#include "integration/zipper.h"

namespace vantage {

struct UnionOptions {
  ZipperOptions zipper;
  ConsensusOptions consensus;
};

/// Two composites that are aligned as one, in coordinates of the reference: the views of both where the refinement of
/// the pose put them (or, without one, where the pose does), first those of the reference; their tables and ties; and a
/// model that is zippered of all of them. A further composite is aligned with that. Steps reported: integrate.
/// @throws InvalidInput as zipper, or when the refinement is of other composites; Cancelled
[[nodiscard]] Composite united(const Composite& reference, const Composite& moved, const AlignedPose& pose,
                               const UnionOptions& options, const Progress& progress = {});

}  // namespace vantage
