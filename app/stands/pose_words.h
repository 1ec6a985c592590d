#pragma once

#include <QString>

#include "acquisition/stand_alignment.h"

namespace vantage {

/// What came of aligning a stand, as a sentence with what to do; null: it was not tried yet.
/// @param known it is in place
[[nodiscard]] QString verdictText(int stand, const StandAlignment* alignment, bool known);

/// "Pose 1, possible", "Pose 2, unlikely".
[[nodiscard]] QString poseTitle(int index, const StandPose& pose);

/// The numbers of a pose in a few lines.
[[nodiscard]] QString poseFigures(const StandPose& pose);

}  // namespace vantage
