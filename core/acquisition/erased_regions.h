#pragma once

#include <optional>
#include <span>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "integration/erasing.h"
#include "registration/registration_target.h"

namespace vantage {

/// What the operator erased holds for all scans of its stand, those taken so far and later ones: what is there is not
/// the object. Scans and views stay whole, so that they find their places as well as before; what is erased is left out
/// of the model, of what the planner wants to see, and of what one stand says of another.

/// All that is erased, in the frames of the composites of the stands.
[[nodiscard]] ErasedSpace erasedSpaceOf(const std::vector<Stand>& stands);

/// The number of the next erasure.
[[nodiscard]] int nextErasure(const std::vector<Stand>& stands);
/// The numbers of those that hold, ascending.
[[nodiscard]] std::vector<int> erasuresOf(const std::vector<Stand>& stands);

/// The views as they are integrated: whole within one stand, where the model is cut afterwards so that the rest of it
/// stays as it is; without what is erased where several stands meet, or a holder would take the place of what another
/// stand saw behind it.
[[nodiscard]] std::vector<View> viewsToIntegrate(std::vector<View> views, const ErasedSpace& space);

/// What scans of a stand are registered with: the model, and what of that stand is erased from it.
/// @pre the state has a model
[[nodiscard]] RegistrationTarget targetInStand(const AcquisitionState& state, int stand);

/// What hides from scans of a stand: the model, and what of that stand is erased from it. @pre the state has a model
[[nodiscard]] Mesh surfaceInStand(const AcquisitionState& state, int stand);

/// The vertices of the model beyond which lies what is erased in the stand of now, see erasedBorder; none where nothing
/// is, or the model is not of that stand's composite. @pre the state has a model
[[nodiscard]] std::vector<std::uint8_t> erasedBorderNow(const AcquisitionState& state);

/// What an erasure takes out of a model.
struct Erasure {
  std::vector<std::uint8_t> triangles;  ///< of the model: 1 for those that go
  std::size_t samples = 0;              ///< vertices that go
  std::size_t pieces = 0;               ///< in which they hang together
  double area = 0.0;                    ///< [mm^2]
};

/// Where something is to be erased.
struct ErasingRegion {
  int stand = 0;       ///< the region is in the frame of its table
  Region region = {};  ///< see geometry/region.h
  bool alone = false;  ///< only what was seen in this stand; else in all stands that make the model
};

/// The space alone that a further erasure takes out of a state. @throws InvalidInput for a region that is none
[[nodiscard]] ErasedSpace spaceOf(const AcquisitionState& state, const ErasingRegion& erasing);

/// What it would take out of the model: nothing is changed. @pre the state has a model
/// @throws InvalidInput for a region that is none; Cancelled
[[nodiscard]] Erasure erasureOf(const AcquisitionState& state, const ErasingRegion& erasing,
                                const Progress& progress = {});

/// A lasso that ends behind what of the model it shows first: before the first gap in depth that is wider than what
/// neighbours on a surface may differ by. The far side of the object stays.
/// @param lasso in the frame of the table of the stand of now @pre the state has a model
[[nodiscard]] Prism frontOf(const AcquisitionState& state, Prism lasso);

/// The pieces of the model that hang together with nothing else, up to an area each [mm^2], but for the largest: what
/// is nearer to them than to the rest. Frame of the table of the stand of now; nothing where there are none.
/// @pre the state has a model
[[nodiscard]] std::optional<NearPoints> loosePiecesRegion(const AcquisitionState& state, double largestArea);

}  // namespace vantage
