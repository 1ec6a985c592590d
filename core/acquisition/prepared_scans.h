#pragma once

#include <vector>

#include "acquisition/acquisition_state.h"
#include "base/progress.h"
#include "registration/view_network.h"

namespace vantage {

/// Makes the views of a state, and a scan that is to become one, ready for registration, where they are not: a view is
/// prepared once for all the steps that work with it. @pre `added` has a mesh. @throws Cancelled
void prepareScans(AcquisitionState& state, KeptScan& added, const Progress& progress);

/// Scans that have a mesh, ready for registration; as they were prepared, or anew where they were not.
/// @throws Cancelled
[[nodiscard]] std::vector<PreparedView> preparedViews(const std::vector<const KeptScan*>& scans,
                                                      const Progress& progress);
/// The same of views that stand for the scans, one each and in their order; made anew where a view is not the scan's.
[[nodiscard]] std::vector<PreparedView> preparedViews(const std::vector<const KeptScan*>& scans,
                                                      const std::vector<View>& views, const Progress& progress);

}  // namespace vantage
