#pragma once

#include <functional>
#include <memory>

#include "acquisition/acquisition.h"

namespace vantage {

/// Hears of what aligning a stand came to, also where that is not recorded.
using StandTold = std::function<void(int stand, const std::shared_ptr<const StandAlignment>& alignment)>;

/// Aligns as always, and tells.
[[nodiscard]] std::shared_ptr<const StandAligner> tellingAligner(StandTold tell);

/// Scans once, or until the end. A stand that is not known yet is aligned meanwhile as soon as that succeeds, see
/// findPlaces.
/// @param pause asked after every scan: whether to stop there @return whether the acquisition has ended
/// @throws as Acquisition::scanNext
bool scanStand(Acquisition& acquisition, bool untilTheEnd, const std::function<bool()>& pause,
               const Progress& progress);

}  // namespace vantage
