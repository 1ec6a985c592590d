#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "layers/view_snapshot.h"
#include "look/colour_map.h"

namespace vantage {

/// Which image in positional space is shown.
enum class PositionalImageKind : std::uint8_t {
  Void,     ///< P_v [mm^2]
  Seen,     ///< P_s [mm^2]
  Scanner,  ///< P_c^i: of one position, its cells; of all, how many positions look through a cell
};

/// Only the cells of directions near one, off the normal of their surface cell.
struct DirectionWindow {
  double phi = 0.0;                 ///< [rad] about the vertical
  double psi = 0.0;                 ///< [rad] above the horizon
  double halfWidth = radians(3.0);  ///< [rad] in either

  bool operator==(const DirectionWindow&) const = default;
};

/// What of positional space is shown.
struct PositionalViewOptions {
  PositionalImageKind kind = PositionalImageKind::Void;
  std::optional<DirectionWindow> direction = std::nullopt;  ///< unset: summed over all directions
  std::optional<int> position = std::nullopt;               ///< of P_c^i; unset: all positions
  bool legends = true;

  bool operator==(const PositionalViewOptions&) const = default;
};

/// A cell of the surface of positional space.
struct MapCell {
  int row = 0;
  int column = 0;

  bool operator==(const MapCell&) const = default;
};

/// A value for every cell of the surface of positional space.
struct CellField {
  PositionalSpaceShape shape;
  std::vector<double> values;  ///< rows x columns, row-major
  double maximum = 0.0;
  QString title;  ///< "P_v, void"
  QString unit;   ///< "mm²"
  ColourMap map = ColourMap::Viridis;

  [[nodiscard]] double at(const MapCell& cell) const { return values[numberOf(cell)]; }
  [[nodiscard]] std::uint32_t numberOf(const MapCell& cell) const {  ///< row * columns + column
    return static_cast<std::uint32_t>(cell.row * shape.columns + cell.column);
  }
};

/// The field that options ask for; nothing when the snapshot lacks the images for it.
[[nodiscard]] std::optional<CellField> cellField(const ViewSnapshot& snapshot, const PositionalViewOptions& options);

}  // namespace vantage
