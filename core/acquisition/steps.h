#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

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
  std::optional<Mechanics> mechanics;  ///< of the moves between scans; unset: nothing is known of them
  TriangulationOptions triangulation;
  IcpOptions registration;
  MultiViewOptions refinement;
  ZipperOptions zipper;
  ConsensusOptions consensus;
  PlannerOptions planner;
};

/// Options that fit a scanner: its breakdown angle, and the errors of its turntable as what is known of a pose. Of a
/// state without a profile those of an import.
[[nodiscard]] StepOptions stepOptionsFor(const ScannerProfile& profile, const AcquisitionSettings& settings);
[[nodiscard]] StepOptions stepOptionsFor(const AcquisitionState& state);

/// A scan with its number in the session.
struct NumberedScan {
  std::int64_t number = -1;
  std::shared_ptr<const RangeImage> image;
};

/// Adds one scan: triangulates it, registers it with the model, spreads the loop-closing error over all views and
/// zippers it in. The first scan keeps its nominal pose for ever. When registration fails the scan is kept as rejected
/// and the model stays as it is. Steps reported: register, integrate.
/// @param predicted what the plan that chose the position promised.
/// @throws InvalidInput when the scan has no surface at all; Cancelled
[[nodiscard]] AcquisitionState addScan(const AcquisitionState& state, const NumberedScan& scan,
                                       std::optional<PositionScore> predicted, const StepOptions& options,
                                       const Progress& progress);

/// The state without a view, which keeps its place among those left out. The model is made anew of the others.
/// @throws InvalidInput when there is no view of that scan, or no other; Cancelled
[[nodiscard]] AcquisitionState leaveOutView(const AcquisitionState& state, std::int64_t scan,
                                            const StepOptions& options, const Progress& progress);

/// The opposite: views stand in the order of their scans, and the model is made anew.
/// @throws InvalidInput when no view of that scan was left out; Cancelled
[[nodiscard]] AcquisitionState takeBackView(const AcquisitionState& state, std::int64_t scan,
                                            const StepOptions& options, const Progress& progress);

/// The model of views at their poses, made anew.
[[nodiscard]] std::shared_ptr<const Model> integrateViews(const std::vector<View>& views, const StepOptions& options,
                                                          const Progress& progress);

/// The nominal pose of a position, carried over from where the last view was found: the errors of past moves stay.
[[nodiscard]] Pose expectedPose(const AcquisitionState& state, const RangeImage& image);

/// The plan after the last view.
[[nodiscard]] Plan planAfter(const AcquisitionState& state, const ScannerImages& images, const StepOptions& options,
                             const Progress& progress);

}  // namespace vantage
