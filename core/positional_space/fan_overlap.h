#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <cstdint>
#include <vector>

namespace vantage {

struct SlopeRange {
  float low;
  float high;
};

/// Slopes across and up under which something is seen through a surface cell.
struct FanRange {
  SlopeRange across;
  SlopeRange up;
};

/// Slopes that the ranging rays of many cells have, fanned over their surface cells.
struct FanReach {
  std::vector<float> lowAcross, highAcross, lowUp, highUp;
};

/// Cells that are tested at once.
inline constexpr std::uint32_t kFanLanes = 4;

/// Tells which of kFanLanes neighbouring cells have a fan that overlaps a range of slopes, borders included: bit i of
/// the answer is cell `first` + i. On any machine; the reach holds kFanLanes cells from `first` on.
class PortableFanOverlap {
 public:
  explicit PortableFanOverlap(const FanRange& seen) : seen_(seen) {}

  [[nodiscard]] unsigned operator()(const FanReach& reach, std::uint32_t first) const {
    unsigned overlap = 0;
    for (std::uint32_t lane = 0; lane < kFanLanes; ++lane) {
      const std::uint32_t k = first + lane;
      const unsigned across = static_cast<unsigned>(reach.highAcross[k] >= seen_.across.low) &
                              static_cast<unsigned>(reach.lowAcross[k] <= seen_.across.high);
      const unsigned up = static_cast<unsigned>(reach.highUp[k] >= seen_.up.low) &
                          static_cast<unsigned>(reach.lowUp[k] <= seen_.up.high);
      overlap |= (across & up) << lane;
    }
    return overlap;
  }

 private:
  FanRange seen_;
};

#if defined(__SSE2__)
/// The same answers in vector instructions.
class SseFanOverlap {
 public:
  explicit SseFanOverlap(const FanRange& seen)
      : lowAcross_(_mm_set1_ps(seen.across.low)),
        highAcross_(_mm_set1_ps(seen.across.high)),
        lowUp_(_mm_set1_ps(seen.up.low)),
        highUp_(_mm_set1_ps(seen.up.high)) {}

  [[nodiscard]] unsigned operator()(const FanReach& reach, std::uint32_t first) const {
    const __m128 across = _mm_and_ps(_mm_cmpge_ps(_mm_loadu_ps(&reach.highAcross[first]), lowAcross_),
                                     _mm_cmple_ps(_mm_loadu_ps(&reach.lowAcross[first]), highAcross_));
    const __m128 up = _mm_and_ps(_mm_cmpge_ps(_mm_loadu_ps(&reach.highUp[first]), lowUp_),
                                 _mm_cmple_ps(_mm_loadu_ps(&reach.lowUp[first]), highUp_));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(across, up)));
  }

 private:
  __m128 lowAcross_, highAcross_, lowUp_, highUp_;
};
using FastFanOverlap = SseFanOverlap;
#else
using FastFanOverlap = PortableFanOverlap;
#endif

}  // namespace vantage
