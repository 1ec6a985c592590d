#pragma once

#include <vector>

#include "layers/view_snapshot.h"

namespace vantage::testing {

/// The sample mug as a coarse scanner with 3 mm between samples acquires it: snapshots after every view, made once per
/// program.
[[nodiscard]] const std::vector<SharedSnapshot>& mugSnapshots();

/// After three views, with a next view proposed; and at the end, when nothing is left to see.
[[nodiscard]] SharedSnapshot mugUnderWay();
[[nodiscard]] SharedSnapshot mugFinished();

/// The same of a mug with blue and green rings, redder to one side; the scans of the first views saw no colours.
[[nodiscard]] SharedSnapshot paintedMug(std::size_t viewsWithout = 0);

}  // namespace vantage::testing
