#pragma once

#include <optional>

#include "acquisition/acquisition_state.h"
#include "base/progress.h"
#include "integration/consensus.h"
#include "integration/zipper.h"
#include "planning/planner.h"
#include "positional_space/scanner_images.h"
#include "registration/icp.h"
#include "registration/multi_view.h"

namespace vantage {

/// Options of every operation that a step runs.
struct StepOptions {
  TriangulationOptions triangulation;
  IcpOptions registration;
  MultiViewOptions refinement;
  ZipperOptions zipper;
  ConsensusOptions consensus;
  PlannerOptions planner;
};

/// Options that fit a scanner: its breakdown angle, and the errors of its turntable as what is known of a pose.
[[nodiscard]] StepOptions stepOptionsFor(const ScannerProfile& profile, const AcquisitionSettings& settings);

/// Adds one scan: triangulates it, registers it with the model, spreads the loop-closing error over all views and
/// zippers it in. The first scan keeps its nominal pose for ever. When registration fails the scan is kept as rejected
/// and the model stays as it is. Steps reported: register, integrate.
/// @param predicted what the plan that chose the position promised.
/// @throws InvalidInput when the scan has no surface at all; Cancelled
[[nodiscard]] AcquisitionState addScan(const AcquisitionState& state, RangeImage image,
                                       std::optional<PositionScore> predicted, const StepOptions& options,
                                       const Progress& progress);

/// The nominal pose of a position, carried over from where the last view was found: the errors of past moves stay.
[[nodiscard]] Pose expectedPose(const AcquisitionState& state, const RangeImage& image);

/// The plan after the last view.
[[nodiscard]] Plan planAfter(const AcquisitionState& state, const ScannerImages& images, const StepOptions& options,
                             const Progress& progress);

}  // namespace vantage
