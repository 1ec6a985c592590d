#pragma once

#include <QPainter>
#include <cstdint>
#include <vector>

#include "layers/cell_field.h"
#include "look/theme.h"

namespace vantage {

/// What is marked in an unrolled map.
struct UnrolledMapMarks {
  std::vector<std::uint32_t> cells;  ///< row * columns + column
  int row = -1;                      ///< of the cell pointed at; -1 for none
  int column = -1;
};

/// A field unrolled: azimuth to the right from 0 to 360 degrees, height upward, with axes and legend.
/// @param notes written below the title
void paintUnrolledMap(QPainter& painter, const QRectF& area, const CellField& field, const QStringList& notes,
                      const UnrolledMapMarks& marks, const Theme& theme);

struct MapCell {
  int row = -1;
  int column = -1;
};
/// The cell under a point of the map painted in that area; -1 for none.
[[nodiscard]] MapCell cellAt(const QPointF& point, const QRectF& area, const PositionalSpaceShape& shape);

}  // namespace vantage
