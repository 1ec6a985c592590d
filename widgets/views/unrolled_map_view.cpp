#include "views/unrolled_map_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "charts/axis.h"
#include "charts/unrolled_map_chart.h"
#include "layers/positional_links.h"

namespace vantage {

UnrolledMapView::UnrolledMapView(QWidget* parent) : QWidget(parent), theme_(&lightTheme()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Positional space, unrolled"));
}

void UnrolledMapView::setSnapshot(const SharedSnapshot& snapshot) {
  snapshot_ = snapshot;
  highlighted_.clear();
  pointed_.reset();
  refresh();
}

void UnrolledMapView::setOptions(const PositionalViewOptions& options) {
  if (options == options_) return;
  options_ = options;
  refresh();
}

void UnrolledMapView::refresh() {
  field_ = snapshot_ ? cellField(*snapshot_, options_) : std::nullopt;
  update();
}

void UnrolledMapView::highlightCells(const std::vector<std::uint32_t>& cells) {
  highlighted_ = cells;
  update();
}

void UnrolledMapView::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void UnrolledMapView::pointAt(const std::optional<MapCell>& cell) {
  if (cell == pointed_) return;
  pointed_ = cell;
  update();
}

void UnrolledMapView::moveTo(const std::optional<MapCell>& cell) {
  if (cell == pointed_) return;
  pointAt(cell);
  emit cellHovered(cell);
}

void UnrolledMapView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!field_) {
    painter.fillRect(rect(), theme_->panel);
    paintText(painter, QRectF(rect()).center(), Qt::AlignHCenter | Qt::AlignVCenter, tr("No plan yet"),
              theme_->mutedText, 13.0);
    return;
  }
  QStringList notes;
  if (pointed_) notes << describeCell(*snapshot_, *field_, *pointed_);
  paintUnrolledMap(painter, rect(), *field_, notes, {highlighted_, pointed_}, *theme_);
}

void UnrolledMapView::mouseMoveEvent(QMouseEvent* event) {
  if (!field_) return;
  moveTo(cellAt(event->position(), rect(), field_->shape));
}

void UnrolledMapView::mousePressEvent(QMouseEvent* event) {
  if (!field_ || event->button() != Qt::LeftButton) return;
  if (const auto cell = cellAt(event->position(), rect(), field_->shape)) emit cellPicked(*cell);
}

void UnrolledMapView::leaveEvent(QEvent*) {
  moveTo(std::nullopt);
}

void UnrolledMapView::keyPressEvent(QKeyEvent* event) {
  if (!field_) return QWidget::keyPressEvent(event);
  const int rows = field_->shape.rows;
  const int columns = field_->shape.columns;
  const auto [row, column] = pointed_.value_or(MapCell{rows / 2, 0});
  switch (event->key()) {
    case Qt::Key_Left:
      return moveTo(MapCell{row, (column + columns - 1) % columns});
    case Qt::Key_Right:
      return moveTo(MapCell{row, (column + 1) % columns});
    case Qt::Key_Up:
      return moveTo(MapCell{std::min(rows - 1, row + 1), column});
    case Qt::Key_Down:
      return moveTo(MapCell{std::max(0, row - 1), column});
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (pointed_) emit cellPicked(*pointed_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace vantage
