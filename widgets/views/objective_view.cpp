#include "views/objective_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace vantage {

ObjectiveView::ObjectiveView(QWidget* parent) : QWidget(parent), theme_(&lightTheme()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Objective of every position"));
}

void ObjectiveView::setSnapshot(const SharedSnapshot& snapshot) {
  data_ = snapshot ? objectiveChartData(*snapshot) : ObjectiveChartData{};
  hovered_ = -1;
  if (examined_ >= static_cast<int>(data_.positions.size())) examined_ = -1;
  update();
}

void ObjectiveView::setChartStyle(ObjectiveStyle style) {
  style_ = style;
  update();
}

void ObjectiveView::examine(int position) {
  examined_ = position < static_cast<int>(data_.positions.size()) ? position : -1;
  update();
}

void ObjectiveView::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void ObjectiveView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintObjective(painter, rect(), data_, style_, {hovered_, examined_}, *theme_);
}

void ObjectiveView::pointAt(int position) {
  if (position == hovered_) return;
  hovered_ = position;
  emit positionHovered(position);
  update();
}

void ObjectiveView::mouseMoveEvent(QMouseEvent* event) {
  pointAt(positionAt(event->position(), rect(), data_, style_));
}

void ObjectiveView::mousePressEvent(QMouseEvent* event) {
  const int position = positionAt(event->position(), rect(), data_, style_);
  if (event->button() == Qt::LeftButton && position >= 0) emit positionPicked(position);
}

void ObjectiveView::leaveEvent(QEvent*) {
  pointAt(-1);
}

void ObjectiveView::keyPressEvent(QKeyEvent* event) {
  const auto count = static_cast<int>(data_.positions.size());
  const int from = hovered_ >= 0 ? hovered_ : std::max(0, data_.chosen);
  if (count > 0 && event->key() == Qt::Key_Right)
    pointAt((from + 1) % count);
  else if (count > 0 && event->key() == Qt::Key_Left)
    pointAt((from + count - 1) % count);
  else if (hovered_ >= 0 && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
    emit positionPicked(hovered_);
  else
    QWidget::keyPressEvent(event);
}

}  // namespace vantage
