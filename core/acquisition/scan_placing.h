#pragma once

#include <optional>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "registration/multi_view.h"
#include "registration/pose_prior.h"
#include "registration/view_network.h"

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
/// stand was found (the errors of past moves stay), else from how the object stands.
/// @pre the scan's stand belongs to the composite in work
[[nodiscard]] Pose expectedPose(const AcquisitionState& state, const RangeImage& image);

/// Whether a scan found its place.
struct FoundPlace {
  bool found = false;
  /// The views of the model and the scan, made ready to be refined; empty where that was not needed.
  std::vector<PreparedView> prepared;
};
/// Registers a scan with the model: its place, status and registration become what was found. A table that slipped is
/// noticed, and where a person may have turned it to is searched. @throws Cancelled
[[nodiscard]] FoundPlace findPlace(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                                   const Progress& progress);

}  // namespace vantage
