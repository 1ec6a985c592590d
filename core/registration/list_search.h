#pragma once

#include <span>
#include <vector>

#include "registration/pose_list.h"
#include "registration/view_network.h"

namespace vantage {

/// Lists of poses under which scans that follow each other agree better than under the given one: turns by another
/// factor between -2.5 and 2.5, inverse poses, other units, other axes of the scanner. The best first, at most four.
/// @param given T_object_scanner, one per view
/// @throws Cancelled
[[nodiscard]] std::vector<MendedList> betterLists(std::span<const PreparedView> views, std::span<const Pose> given,
                                                  const Progress& progress);

}  // namespace vantage
