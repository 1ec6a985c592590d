#pragma once

#include <optional>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "registration/multi_view.h"
#include "registration/pose_prior.h"

namespace vantage {

/// What is known of the motion from one scan to a later one: the table moved for every scan in between, also for those
/// that are no views. Who turned it by hand begins anew every time.
[[nodiscard]] std::optional<PosePrior> priorOf(const StepOptions& options, const KeptScan& from, const KeptScan& to);

/// What a table leaves open, with its axis where it is while the object stands so.
[[nodiscard]] PosePrior aboutTable(const PosePrior& onTable, const Pose& T_object_table);

/// What the mechanics know of the motions between views of the model that follow each other in one stand. Between
/// stands the object was moved by hand.
[[nodiscard]] std::vector<PoseTie> tiesOf(const AcquisitionState& state, const StepOptions& options);

/// T_object_scanner of a scan as it is expected: its pose on the table, carried over from where the last view of its
/// stand was found that was taken where it was said to be (the errors of past moves stay), else from how the object
/// stands.
/// @pre the scan's stand belongs to the composite in work
[[nodiscard]] Pose expectedPose(const AcquisitionState& state, const RangeImage& image);

/// Registers a scan with the model: its place, status and registration become what was found. A table that slipped is
/// noticed, and where a person may have turned it to is searched. Of one that does not fit where it was said to be
/// taken the finding tells where it does (see otherTurnOf).
/// @return whether it found its place. @throws Cancelled
[[nodiscard]] bool findPlace(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                             const Progress& progress);

/// The same for a scan that found no place before: where it may fit else is not asked again. @throws Cancelled
[[nodiscard]] bool findPlaceAgain(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                                  const Progress& progress);

}  // namespace vantage
