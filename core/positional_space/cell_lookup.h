#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "positional_space/scanner_images.h"

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

/// Finds the occupied cells of a surface cell by slope: those whose ranging rays, fanned over the surface cell, overlap
/// a range of slopes. Surface cells are those of one period, as stored in ScannerImages::Data.
class CellLookup {
 public:
  static constexpr int kStepsUp = 32;
  static constexpr int kStepsAcross = 64;

  explicit CellLookup(const ScannerImages& scanner);

  /// All slopes on (-1, 1): slope / (1 + |slope|), which is cheap and makes fans about equally wide.
  [[nodiscard]] static float folded(float slope) { return slope / (1.0F + std::abs(slope)); }

  /// The step of a folded slope.
  [[nodiscard]] static int stepOf(float folded, int steps) {
    const float step = (folded + 1.0F) * (0.5F * static_cast<float>(steps));
    return static_cast<int>(std::clamp(step, 0.0F, static_cast<float>(steps - 1)));
  }

  /// Bounds of the fans of all occupied cells of a surface cell; low > high when there are none.
  [[nodiscard]] const SlopeRange& upRange(std::size_t surfaceCell) const { return lists_[surfaceCell].all; }

  /// Most occupied cells of a surface cell.
  [[nodiscard]] std::size_t longest() const { return longest_; }

  /// Writes the numbers of the occupied cells whose fan overlaps `seen` to `found`, which has room for longest().
  /// @param firstAcross, lastAcross steps of the folded seen.across
  /// @return how many.
  std::size_t findOverlapping(std::size_t surfaceCell, const FanRange& seen, int firstAcross, int lastAcross,
                              std::uint32_t* found) const {
    const List& list = lists_[surfaceCell];
    int first = list.firstUp;
    int last = list.lastUp;
    if (first < last) {
      first = std::max(first, stepOf(folded(seen.up.low) - list.margin, kStepsUp));
      last = std::min(last, stepOf(folded(seen.up.high) + list.margin, kStepsUp));
    }
    std::size_t count = 0;
    for (int step = first; step <= last; ++step) {
      const auto* ranges = &steps_[list.start + static_cast<std::size_t>((step - list.firstUp) * kStepsAcross)];
      const std::uint32_t end = ranges[lastAcross][1];
      for (std::uint32_t k = ranges[firstAcross][0]; k < end; ++k) {
        // Counted rather than branched on: which cells overlap cannot be predicted.
        const FanRange& fan = fans_[k];
        const int overlap = static_cast<int>(fan.across.high >= seen.across.low) &
                            static_cast<int>(fan.across.low <= seen.across.high) &
                            static_cast<int>(fan.up.high >= seen.up.low) & static_cast<int>(fan.up.low <= seen.up.high);
        found[count] = order_[k];
        count += static_cast<std::size_t>(overlap);
      }
    }
    return count;
  }

 private:
  struct List {
    int firstUp = 0;  // steps of the slopes up that are in use
    int lastUp = -1;
    float margin = 0.0F;    // of the folded slopes up, by which fans reach beyond their middle
    std::size_t start = 0;  // of its steps in steps_
    SlopeRange all{};
  };

  void addFan(const SurfaceCell& surface, const OccupiedCell& cell);
  void addList(const ScannerImages::Data& data, std::uint32_t begin, std::uint32_t end);
  void addSteps(std::uint32_t first, std::uint32_t last);

  std::vector<std::uint32_t> order_;  // occupied cells by surface cell, step of the slope up, slope across
  std::vector<FanRange> fans_;        // in that order
  std::vector<List> lists_;           // per surface cell
  std::size_t longest_ = 0;
  // Per step up and step across where in order_ those cells begin and end whose fan reaches into the step.
  std::vector<std::array<std::uint32_t, 2>> steps_;
};

}  // namespace vantage
