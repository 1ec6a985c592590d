#pragma once

#include <QStringList>
#include <cstdint>
#include <vector>

#include "layers/cell_field.h"

namespace vantage {

/// Which void patches are seen through which cells of the surface of positional space, both ways. Cells are numbered
/// row * columns + column. Immutable.
class PositionalLinks {
 public:
  /// @param planImages of those scanner images; its void image keeps its sightings.
  PositionalLinks(const ScannerImages& scannerImages, const PlanImages& planImages);

  [[nodiscard]] std::vector<std::uint32_t> patchesThrough(std::uint32_t surfaceCell) const;  ///< ascending
  [[nodiscard]] std::vector<std::uint32_t> cellsOf(std::uint32_t patch) const;               ///< ascending

 private:
  struct Link {
    std::uint32_t from;
    std::uint32_t to;
    auto operator<=>(const Link&) const = default;  // NOLINT(modernize-use-nullptr): there is no pointer
  };
  [[nodiscard]] static std::vector<std::uint32_t> linked(const std::vector<Link>& links, std::uint32_t from);

  std::vector<Link> patchesOfCell_;
  std::vector<Link> cellsOfPatch_;
};

/// What hovering over a cell tells, a line each: where it is and its value; in which directions rays of how many
/// positions leave through it.
[[nodiscard]] QStringList describeCell(const ViewSnapshot& snapshot, const CellField& field, const MapCell& at);

}  // namespace vantage
