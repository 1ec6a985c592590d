#pragma once

#include <optional>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "composites/composite.h"

namespace vantage {

/// Every stand is acquired as a composite of its own, in the frame of its table, until it is known how the object
/// stands in it (Pito 1999, 6.3). Stands that are known relative to each other are one composite, the object. Of one
/// composite the state has views (ScanStatus::In), model and plan: that of the stand of now. The views of the others
/// are set aside (ScanStatus::Aside), and so are their models (AcquisitionState::aside).

/// The stand that the object is known by: the first one whose pose is known. The object's frame is that of its table,
/// and its number is that of the object's composite: of this stand and all that are known relative to it.
[[nodiscard]] int referenceOf(const std::vector<Stand>& stands);

/// Whether it is known how the object stands in a stand.
[[nodiscard]] bool isOfObject(const AcquisitionState& state, int stand);

/// The composite of a stand: that of the object, or the stand itself.
[[nodiscard]] int compositeOf(const AcquisitionState& state, int stand);

/// The side that the object was to be put on in a stand, in the coordinates of the object; nothing where none was
/// advised, or where it is not known how the object stands in the stand that it was told in.
[[nodiscard]] std::optional<Vec3> sideMeant(const AcquisitionState& state, int stand);

/// The composite that the views and the model of the state are of.
[[nodiscard]] int compositeInWork(const AcquisitionState& state);

/// How the object stands in a stand, in the frame of its composite: T_object_table, or the identity for a composite
/// of one stand.
[[nodiscard]] Pose tableOf(const AcquisitionState& state, int stand);

/// The state with another composite in its views and model. Its plan is gone unless it is the one in work already.
[[nodiscard]] AcquisitionState withComposite(const AcquisitionState& state, int composite);

/// The state with the object in its views and model: what has been put together so far.
[[nodiscard]] AcquisitionState withObject(const AcquisitionState& state);

/// The stands that have views and are not known yet, in order.
[[nodiscard]] std::vector<int> standsToAlign(const AcquisitionState& state);

/// The composite in work as an aligner takes it. @pre it has a model
[[nodiscard]] Composite compositeForAligner(const AcquisitionState& state, const StepOptions& options);

}  // namespace vantage
