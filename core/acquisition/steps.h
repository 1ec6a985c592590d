#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "positional_space/scanner_images.h"
#include "registration/view_network.h"

namespace vantage {

/// Adds one scan: triangulates it, registers it with the model, spreads the loop-closing error over all views and
/// zippers it in. The first scan keeps its nominal pose for ever. When registration fails the scan is kept as rejected
/// and the model stays as it is. A scan of a stand that is not known yet is added to the composite of that stand, one
/// of a composite that is not worked on waits. Steps reported: register, integrate.
/// @param predicted what the plan that chose the position promised.
/// @throws InvalidInput when the scan is of no stand of the state or, being the first, has no surface at all; Cancelled
[[nodiscard]] AcquisitionState addScan(const AcquisitionState& state, const NumberedScan& scan,
                                       std::optional<PositionScore> predicted, const StepOptions& options,
                                       const Progress& progress);

/// The state with another status of one scan, which keeps its place in the list. The model is made anew of the scans
/// that are in. @pre the scan has a mesh. @throws Cancelled
[[nodiscard]] AcquisitionState withStatus(const AcquisitionState& state, std::int64_t scan, ScanStatus status,
                                          const StepOptions& options, const Progress& progress);

/// The state with a refused scan as a view from another turn of the table, one that it was found to fit, and the model
/// made anew. @pre fitsTurn, its stand belongs to the composite in work. @throws InvalidInput when it fits there no
/// more; Cancelled
[[nodiscard]] AcquisitionState takeAsFrom(const AcquisitionState& state, std::int64_t scan, double tableDeg,
                                          const StepOptions& options, const Progress& progress);

/// Moves the views of the model to where all of them and the mechanics agree best. What that settles of doubts is
/// settled. @throws Cancelled
void refineModelViews(AcquisitionState& state, const StepOptions& options, const Progress& progress);

/// The model of views at their poses, made anew, without what is erased in their stands.
[[nodiscard]] std::shared_ptr<const Model> integrateViews(const std::vector<View>& whole,
                                                          const std::vector<Stand>& stands, const StepOptions& options,
                                                          const Progress& progress);

/// What a plan for the stand of now is made from, and what explains it.
/// @pre the state has a profile and a model
[[nodiscard]] PlanInput planInputOf(const AcquisitionState& state);

/// The plan for the stand of now. @pre there is a view
/// No second view in a row of doubts is left to the table alone: errors of its moves would pile up.
[[nodiscard]] Plan planAfter(const AcquisitionState& state, const ScannerImages& images, const StepOptions& options,
                             const Progress& progress);

}  // namespace vantage
