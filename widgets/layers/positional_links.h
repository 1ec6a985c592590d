#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "layers/view_snapshot.h"

namespace vantage {

/// Which void patches are seen through which cells of the surface of positional space, both ways. Cells are numbered
/// row * columns + column. Immutable.
class PositionalLinks {
 public:
  /// The snapshot's plan images must keep the sightings of the void.
  PositionalLinks(const ScannerImages& scannerImages, const PlanImages& planImages);

  [[nodiscard]] std::vector<std::uint32_t> patchesThrough(std::uint32_t surfaceCell) const;  ///< ascending
  [[nodiscard]] std::vector<std::uint32_t> cellsOf(std::uint32_t patch) const;               ///< ascending

 private:
  struct Link {
    std::uint32_t cell;
    std::uint32_t patch;
    auto operator<=>(const Link&) const = default;
  };
  std::vector<Link> byCell_;
  std::vector<Link> byPatch_;
};

/// What hovering over a cell tells: where it is, its value, and in which directions positions look through it.
[[nodiscard]] QString describeCell(const ViewSnapshot& snapshot, const struct CellField& field, int row, int column);

}  // namespace vantage
