#pragma once

#include <string>
#include <vector>

#include "acquisition/steps.h"
#include "base/progress.h"
#include "integration/consensus.h"
#include "integration/zipper.h"
#include "registration/alignment.h"
#include "void_space/void_patch_builder.h"

namespace vantage {

struct ImportOptions {
  /// Recorded scans reach farther round than a breakdown angle of 60 degrees.
  TriangulationOptions triangulation{.breakdownAngle = radians(75.0), .angleSlack = radians(5.0)};
  AlignmentOptions alignment;
  ZipperOptions zipper{.breakdownAngle = radians(75.0)};
  ConsensusOptions consensus;
  VoidOptions voidSpace{.breakdownAngle = radians(75.0)};
};

/// What became of recorded scans.
struct ImportResult {
  AcquisitionState state;                ///< views that found their place, in the order given, and their model
  std::vector<ViewAlignment> alignment;  ///< one per scan given
  ZipperStatistics zippering;
  VoidSurface voids;  ///< what is still void
};

/// Options that fit a scanner, or recorded scans without one.
[[nodiscard]] ImportOptions importOptionsFor(const AcquisitionState& state);

/// Registers recorded scans from their nominal poses, the first of which stays, and zippers those that found their
/// place. Steps reported: register, integrate, void_patches.
/// @throws InvalidInput when there is no scan or the first has no surface; Cancelled
[[nodiscard]] ImportResult importScans(const std::vector<NumberedScan>& scans, const ImportOptions& options,
                                       const Progress& progress);

}  // namespace vantage
