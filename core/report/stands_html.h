#pragma once

#include <string>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "report/html_parts.h"

namespace vantage {

/// The section of the report on the stands of the object: of each how it stood, its views, what came of its alignment,
/// who decided on its pose, and the poses that were found with their evidence. Nothing for an object that was not
/// turned over.
/// @param pictures one per stand, or none
[[nodiscard]] std::string standsHtml(const AcquisitionState& state, const std::vector<ReportPicture>& pictures);

}  // namespace vantage
