#pragma once

#include <nlohmann/json.hpp>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// The stands of the object as the command line contract describes them: how it stood in each (rotation from object to
/// table, row by row), its views in the model, what came of its alignment with every pose that was found.
[[nodiscard]] nlohmann::ordered_json standsJson(const AcquisitionState& state);

/// What came of one alignment.
[[nodiscard]] nlohmann::ordered_json alignmentJson(const StandAlignment& alignment);

}  // namespace vantage
