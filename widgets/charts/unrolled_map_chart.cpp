#include "charts/unrolled_map_chart.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "charts/axis.h"

namespace vantage {
namespace {

constexpr double kLeft = 56.0;
constexpr double kRight = 22.0;
constexpr double kTop = 68.0;
constexpr double kBottom = 26.0;
constexpr double kLegendSpace = 22.0;

struct Layout {
  QRectF map;
  PositionalSpaceShape shape;

  // Columns begin at an azimuth that need not be 0: the first column drawn is the one that holds azimuth 0.
  [[nodiscard]] double azimuthStep() const { return 2.0 * kPi / shape.columns; }
  [[nodiscard]] double xOf(double azimuth) const { return map.left() + azimuth / (2.0 * kPi) * map.width(); }
  [[nodiscard]] double bandHeight() const { return map.height() / shape.rows; }
  [[nodiscard]] double yOf(int row) const { return map.bottom() - (row + 1) * bandHeight(); }
  [[nodiscard]] double startOf(int column) const {
    const double azimuth = std::fmod(shape.firstColumn + column * azimuthStep(), 2.0 * kPi);
    return azimuth < -1e-9 ? azimuth + 2.0 * kPi : azimuth;
  }
};

Layout layoutOf(const QRectF& area, const PositionalSpaceShape& shape) {
  return {area.adjusted(kLeft, kTop, -kRight, -kBottom - kLegendSpace), shape};
}

// A cell that runs over the seam at 360 degrees is drawn on both sides.
std::vector<QRectF> rectsOf(const Layout& layout, const MapCell& cell) {
  const double begin = layout.startOf(cell.column);
  const double end = begin + layout.azimuthStep();
  const auto rect = [&](double from, double to) {
    return QRectF(QPointF(layout.xOf(from), layout.yOf(cell.row)),
                  QPointF(layout.xOf(to), layout.yOf(cell.row) + layout.bandHeight()));
  };
  if (end <= 2.0 * kPi + 1e-9) return {rect(begin, end)};
  return {rect(begin, 2.0 * kPi), rect(0.0, end - 2.0 * kPi)};
}

void paintCells(QPainter& painter, const Layout& layout, const CellField& field) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int row = 0; row < field.shape.rows; ++row)
    for (int column = 0; column < field.shape.columns; ++column) {
      const double share = field.maximum > 0.0 ? field.at({row, column}) / field.maximum : 0.0;
      for (const QRectF& rect : rectsOf(layout, {row, column}))
        painter.fillRect(rect.adjusted(0.0, 0.0, 0.5, 0.5), toColour(colourAt(field.map, share)));
    }
  painter.setRenderHint(QPainter::Antialiasing, true);
}

void outline(QPainter& painter, const Layout& layout, const MapCell& cell, const QPen& pen) {
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  for (const QRectF& rect : rectsOf(layout, cell)) painter.drawRect(rect);
}

void paintAxes(QPainter& painter, const Layout& layout, const Theme& theme) {
  painter.setPen(QPen(theme.grid, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(layout.map);
  const int step = layout.map.width() > 420.0 ? 30 : 90;
  for (int degree = 0; degree <= 360; degree += step) {
    const double x = layout.xOf(radians(degree));
    painter.setPen(QPen(theme.grid, 1.0));
    painter.drawLine(QPointF(x, layout.map.bottom()), QPointF(x, layout.map.bottom() + 4.0));
    paintText(painter, {x, layout.map.bottom() + 5.0}, Qt::AlignHCenter | Qt::AlignTop,
              QString::number(degree) + QChar(0x00B0), theme.mutedText);
  }
  const bool sphere = layout.shape.surface == PositionalSpaceSurface::Sphere;
  const double low = sphere ? -90.0 : layout.shape.bottom;
  const double high = sphere ? 90.0 : layout.shape.top;
  for (int k = 0; k <= 2; ++k) {
    const double y = layout.map.bottom() - 0.5 * k * layout.map.height();
    painter.setPen(QPen(theme.grid, 1.0));
    painter.drawLine(QPointF(layout.map.left() - 4.0, y), QPointF(layout.map.left(), y));
    paintText(painter, {layout.map.left() - 5.0, y}, Qt::AlignRight | Qt::AlignVCenter,
              QString::number(std::lround(low + 0.5 * k * (high - low))) +
                  (sphere ? QStringLiteral("°") : QStringLiteral(" mm")),
              theme.mutedText);
  }
}

}  // namespace

void paintUnrolledMap(QPainter& painter, const QRectF& area, const CellField& field, const QStringList& notes,
                      const UnrolledMapMarks& marks, const Theme& theme) {
  painter.fillRect(area, theme.panel);
  const Layout layout = layoutOf(area, field.shape);
  paintOverlay(painter, area, {QStringList(field.title) + notes, {}}, theme);
  paintCells(painter, layout, field);
  paintAxes(painter, layout, theme);
  painter.save();
  painter.setClipRect(layout.map.adjusted(-1.0, -1.0, 1.0, 1.0));
  for (const std::uint32_t cell : marks.cells)
    outline(painter, layout,
            {static_cast<int>(cell) / field.shape.columns, static_cast<int>(cell) % field.shape.columns},
            QPen(theme.examined, 1.5));
  if (marks.pointed) {
    outline(painter, layout, *marks.pointed, QPen(Qt::black, 3.0));
    outline(painter, layout, *marks.pointed, QPen(Qt::white, 1.5));
  }
  painter.restore();
  paintScaleLine(
      painter, QRectF(area.left() + kLeft, area.bottom() - 22.0, area.width() - kLeft - kRight, 17.0),
      {QCoreApplication::translate("PositionalSpace", "per cell"), field.unit, 0.0, field.maximum, field.map}, theme);
}

std::optional<MapCell> cellAt(const QPointF& point, const QRectF& area, const PositionalSpaceShape& shape) {
  const Layout layout = layoutOf(area, shape);
  if (!layout.map.contains(point)) return std::nullopt;
  const double azimuth = (point.x() - layout.map.left()) / layout.map.width() * 2.0 * kPi;
  double offset = std::fmod(azimuth - shape.firstColumn, 2.0 * kPi);
  if (offset < 0.0) offset += 2.0 * kPi;
  const int column = std::min(static_cast<int>(offset / layout.azimuthStep()), shape.columns - 1);
  const int row = std::min(static_cast<int>((layout.map.bottom() - point.y()) / layout.bandHeight()), shape.rows - 1);
  return MapCell{row, column};
}

}  // namespace vantage
