#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "calibration/screw_fit.h"
#include "registration/registration_scale.h"

namespace vantage {

/// How far a table may turn for a degree that it counts, either way.
struct RatioRange {
  double least = 0.3;
  double most = 3.2;
};

/// A way of turning that was tried: what scans come to when the table turns that way.
struct TurnCandidate {
  double turnsPerCount = 1.0;  ///< true turn about the axis per turn of the table's count; negative: the other way
  ScrewFit fit;
  double misfit = 1.0;  ///< see misfit, within three fine gates
};

/// Tries ratios of both senses from a rough axis: with few points between neighbouring scans first, the likeliest with
/// more. Best first; those that came to the same motion are one.
/// @param tableAngles one per view [deg]
/// @param point on the rough axis; angles of the result are about `direction`
/// @throws Cancelled
[[nodiscard]] std::vector<TurnCandidate> searchTurns(std::span<const PreparedView> views,
                                                     std::span<const double> tableAngles, const Vec3& point,
                                                     const Vec3& direction, const RegistrationScale& scale,
                                                     const RatioRange& range, const Progress& progress);

}  // namespace vantage
