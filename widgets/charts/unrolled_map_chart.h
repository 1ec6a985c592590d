#pragma once

#include <QPainter>
#include <cstdint>
#include <optional>
#include <vector>

#include "layers/cell_field.h"
#include "look/theme.h"

namespace vantage {

/// What is marked in an unrolled map.
struct UnrolledMapMarks {
  std::vector<std::uint32_t> cells;  ///< row * columns + column
  std::optional<MapCell> pointed;    ///< the cell pointed at
};

/// A field unrolled: azimuth to the right from 0 to 360 degrees, height upward, with axes and legend.
/// @param notes written below the title
void paintUnrolledMap(QPainter& painter, const QRectF& area, const CellField& field, const QStringList& notes,
                      const UnrolledMapMarks& marks, const Theme& theme);

/// The cell under a point of the map painted in that area; unset for none.
[[nodiscard]] std::optional<MapCell> cellAt(const QPointF& point, const QRectF& area,
                                            const PositionalSpaceShape& shape);

}  // namespace vantage
