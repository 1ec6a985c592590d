#pragma once

#include "present.h"

namespace vantage {

class FigureTable;

/// Whether there is a model of anything: of the object, or of the stand that is worked on.
[[nodiscard]] bool hasAnyModel(const SharedState& state);

/// Adds what there is of the object, for a state that shows a stand's own model.
void addObject(FigureTable& figures, const AcquisitionState& state);

}  // namespace vantage
