#pragma once

#include <cstddef>

#include "scanner/profile.h"
#include "scanner/thinning.h"

namespace vantage {

/// How many ranging rays a profile says that its scanner has, before any of them is made; 0 where it does not say.
[[nodiscard]] std::size_t raysSaidBy(const ProfileSource& source);

/// What working with a scanner of so many rays takes at the peak, as measured with an object that a third of them meet.
struct MemoryNeeded {
  double megabytes = 0.0;  ///< with one scan [MB]
  double everyScan = 0.0;  ///< more for each further one [MB]
  std::size_t worked = 0;  ///< rays of a scan that are worked on
  [[nodiscard]] double with(int scans) const { return megabytes + everyScan * (scans - 1); }
};
/// With a spacing given nobody knows before the first scan how many rays it leaves: all are counted then.
[[nodiscard]] MemoryNeeded memoryFor(std::size_t rays, const ThinningOptions& thinning);

}  // namespace vantage
