#pragma once

#include <string>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "report/html_parts.h"

namespace vantage {

struct HtmlReportOptions {
  std::string version;                       ///< of the program
  std::vector<ReportPicture> pictures;       ///< of the finished model
  std::vector<ReportPicture> viewPictures;   ///< one per view, or none
  std::vector<ReportPicture> standPictures;  ///< how the object stood, one per stand, or none
};

/// The report of an acquisition as one HTML page that needs no other file: what was scanned and why it ended, pictures,
/// the coverage curve, every view with what the plan promised and what it brought, the stands where
/// there are several, the objective N over the positions,
/// the time of each phase (Pito 1999, Table 2), and the boundary that is left with the reasons. Areas in mm^2, times in
/// s. The same input gives the same bytes.
/// @throws InvalidInput when there are pictures of views, but not one per view, or of stands, but not one per stand.
[[nodiscard]] std::string makeHtmlReport(const AcquisitionState& state, const HtmlReportOptions& options);

}  // namespace vantage
