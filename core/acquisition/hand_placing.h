#pragma once

#include <memory>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "registration/registration_target.h"

namespace vantage {

/// Whether a scan's table was turned by hand: nobody knows well how far.
[[nodiscard]] bool turnedByGuess(const RangeImage& image);

/// Whether a registration leaves open where a view is, turned by hand or not: neither surface nor mechanics hold it to
/// a share of the sample spacing [mm].
[[nodiscard]] bool isUnknown(const RegistrationResult& registration, double spacing);

/// Whether nobody knows well where a view of the model is: it was turned by hand, and neither its surface nor that of
/// the views whose place is known says how far. What fits such views only is as loose as they are.
[[nodiscard]] bool isLoose(const KeptScan& scan);

/// The views of the model whose place is known; all where the place of every one is. They live as long as the state.
[[nodiscard]] std::vector<const KeptScan*> firmScans(const AcquisitionState& state);
[[nodiscard]] std::vector<View> firmViews(const AcquisitionState& state);

/// What a scan is registered with: the views whose place is known where that is not all of them, else the model.
/// @pre there is a model
[[nodiscard]] RegistrationTarget targetOf(const AcquisitionState& state, int stand);

/// A pose of the scanner turned about the axis of the table [rad], counter-clockwise seen from above.
[[nodiscard]] Pose turnedBy(double angle, const Pose& T_object_scanner, const Pose& T_object_table);

/// Registers a scan whose table a person turned, about as far as they were asked: first coarse, then fine, with the
/// views whose place is known, else with the whole model; then it is doubtful at best.
/// @param scan at the pose where it is expected
/// @pre there is a model, the pose of the scan's stand is known. @throws Cancelled
[[nodiscard]] RegistrationResult registerOnTurn(const AcquisitionState& state, const KeptScan& scan,
                                                const StepOptions& options, const Progress& progress);

/// Looks again for the place of every loose view with those whose place is known by now. Those that contradict them
/// leave the model. @return whether the place of a view changed: the model is to be made anew. @throws Cancelled
[[nodiscard]] bool settleLooseViews(AcquisitionState& state, const StepOptions& options, const Progress& progress);

}  // namespace vantage
