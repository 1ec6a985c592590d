#pragma once

#include <optional>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// How much of an acquisition is still to come: an estimate from how it went so far.
struct ViewsToCome {
  int views = 0;         ///< that are still worth taking; at least 1 where one comes next
  double seconds = 0.0;  ///< that they will take, as long each as the last few of its own took
};

/// What views promise falls from one to the next, about by the same share: as it fell over those of the stand of now it
/// goes on to fall, until a view is not worth taking any more, or as many are taken as may be.
/// @return nothing where nothing comes next, or fewer than kViewsForAnEstimate views were taken in the stand of now
[[nodiscard]] std::optional<ViewsToCome> viewsToCome(const AcquisitionState& state);
inline constexpr int kViewsForAnEstimate = 3;

}  // namespace vantage
