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
  row_ = column_ = -1;
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

void UnrolledMapView::pointAt(int row, int column) {
  if (row == row_ && column == column_) return;
  row_ = row;
  column_ = column;
  update();
}

void UnrolledMapView::moveTo(int row, int column) {
  if (row == row_ && column == column_) return;
  pointAt(row, column);
  emit cellHovered(row, column);
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
  if (row_ >= 0) notes << describeCell(*snapshot_, *field_, row_, column_);
  paintUnrolledMap(painter, rect(), *field_, notes, {highlighted_, row_, column_}, *theme_);
}

void UnrolledMapView::mouseMoveEvent(QMouseEvent* event) {
  if (!field_) return;
  const MapCell cell = cellAt(event->position(), rect(), field_->shape);
  moveTo(cell.row, cell.column);
}

void UnrolledMapView::mousePressEvent(QMouseEvent* event) {
  if (!field_ || event->button() != Qt::LeftButton) return;
  const MapCell cell = cellAt(event->position(), rect(), field_->shape);
  if (cell.row >= 0) emit cellPicked(cell.row, cell.column);
}

void UnrolledMapView::leaveEvent(QEvent*) {
  moveTo(-1, -1);
}

void UnrolledMapView::keyPressEvent(QKeyEvent* event) {
  if (!field_) return QWidget::keyPressEvent(event);
  const int rows = field_->shape.rows;
  const int columns = field_->shape.columns;
  const int row = row_ >= 0 ? row_ : rows / 2;
  const int column = column_ >= 0 ? column_ : 0;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveTo(row, (column + columns - 1) % columns);
    case Qt::Key_Right:
      return moveTo(row, (column + 1) % columns);
    case Qt::Key_Up:
      return moveTo(std::min(rows - 1, row + 1), column);
    case Qt::Key_Down:
      return moveTo(std::max(0, row - 1), column);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (row_ >= 0) emit cellPicked(row_, column_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace vantage
