#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "positional_space/fan_overlap.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// An occupied cell with all that tells whether a source is seen through it: one line of the cache.
struct alignas(64) FannedCell {
  std::array<float, 2> slope;  ///< as in OccupiedCell
  std::array<float, 4> fan;
  std::array<float, 2> range;  ///< [mm^2] squared distances from the surface cell between which a source is in range
  std::uint32_t number;        ///< in ScannerImages::Data::cells
  std::uint32_t receiverSide;
};

/// An occupied cell that may be seen through a surface cell: the surface cell's column and the place of the FannedCell.
struct SeenCell {
  std::uint32_t column;
  std::uint32_t place;
};

/// First and last step of a range of slopes.
struct StepRange {
  std::int32_t first;
  std::int32_t last;
};

/// Finds the occupied cells of a surface cell by slope: those whose ranging rays, fanned over the surface cell, overlap
/// a range of slopes. Surface cells are those of one period, as stored in ScannerImages::Data.
class CellLookup {
 public:
  static constexpr int kStepsUp = 8;
  static constexpr int kStepsAcross = 64;

  /// Which instructions find the overlapping cells; what is found is the same.
  enum class Lanes : std::uint8_t {
    Fast,      ///< those of this machine
    Portable,  ///< those of any
  };

  explicit CellLookup(const ScannerImages& scanner, Lanes lanes = Lanes::Fast);

  /// All slopes on (-1, 1): slope / (1 + |slope|), which is cheap and makes fans about equally wide.
  [[nodiscard]] static float folded(float slope) { return slope / (1.0F + std::abs(slope)); }

  /// The step of a folded slope.
  [[nodiscard]] static int stepOf(float folded, int steps) {
    const float step = (folded + 1.0F) * (0.5F * static_cast<float>(steps));
    return static_cast<int>(std::min(std::max(step, 0.0F), static_cast<float>(steps - 1)));
  }

  /// Bounds of the fans of all occupied cells of a surface cell; low > high when there are none.
  [[nodiscard]] const SlopeRange& upRange(std::size_t surfaceCell) const { return lists_[surfaceCell].all; }

  /// Steps of the slopes up that are in use in a surface cell; none when it has no occupied cells.
  [[nodiscard]] StepRange stepsUp(std::size_t surfaceCell) const {
    return {lists_[surfaceCell].firstUp, lists_[surfaceCell].endUp - 1};
  }
  /// By how much of a folded slope up the fans of a surface cell reach beyond their middle.
  [[nodiscard]] float margin(std::size_t surfaceCell) const { return lists_[surfaceCell].margin; }

  /// How many places `findOverlapping` may write to.
  [[nodiscard]] std::size_t room() const { return longest_ + kFanLanes; }

  /// Writes the occupied cells of a surface cell whose fan overlaps `seen` to `found`, with the column.
  /// @param across steps of the folded seen.across
  /// @param up steps of the folded seen.up, widened by the margin, within stepsUp
  /// @return how many.
  std::size_t findOverlapping(std::size_t surfaceCell, const FanRange& seen, StepRange across, StepRange up,
                              std::uint32_t column, SeenCell* found) const {
    return lanes_ == Lanes::Fast ? find(FastFanOverlap(seen), surfaceCell, across, up, column, found)
                                 : find(PortableFanOverlap(seen), surfaceCell, across, up, column, found);
  }

  [[nodiscard]] const FannedCell& cell(std::uint32_t place) const { return cells_[place]; }

 private:
  struct List {
    int firstUp = 0;  // steps of the slopes up that are in use: firstUp to endUp - 1
    int endUp = 0;
    float margin = 0.0F;    // of the folded slopes up, by which fans reach beyond their middle
    std::size_t start = 0;  // of its steps in steps_
    SlopeRange all{};
  };

  template <typename Overlap>
  std::size_t find(const Overlap& overlaps, std::size_t surfaceCell, StepRange across, StepRange up,
                   std::uint32_t column, SeenCell* found) const {
    const List& list = lists_[surfaceCell];
    std::size_t count = 0;
    for (int step = up.first; step <= up.last; ++step) {
      const auto* ranges = &steps_[list.start + static_cast<std::size_t>((step - list.firstUp) * kStepsAcross)];
      const std::uint32_t end = ranges[across.last][1];
      for (std::uint32_t k = ranges[across.first][0]; k < end; k += kFanLanes) {
        unsigned overlap = overlaps(reach_, k);
        // Those of the next step.
        overlap &= 0xfU >> (kFanLanes - std::min(kFanLanes, end - k));
        // Counted rather than branched on: which cells overlap cannot be predicted.
        for (std::uint32_t lane = 0; lane < kFanLanes; ++lane) {
          found[count] = {column, k + lane};
          count += overlap >> lane & 1U;
        }
      }
    }
    return count;
  }

  void addCell(const ScannerImages::Data& data, const SurfaceCell& surface, std::uint32_t number);
  void addList(std::uint32_t begin, std::uint32_t end);
  void addSteps(std::uint32_t first, std::uint32_t last);

  Lanes lanes_;
  std::vector<FannedCell> cells_;  // by surface cell, step of the slope up, slope across
  FanReach reach_;                 // likewise; kFanLanes more than there are cells
  std::vector<List> lists_;        // per surface cell
  std::size_t longest_ = 0;
  // Per step up and step across where in cells_ those cells begin and end whose fan reaches into the step.
  std::vector<std::array<std::uint32_t, 2>> steps_;
};

}  // namespace vantage
