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
  hovered_.reset();
  examine(examined_);
}

void ObjectiveView::setChartStyle(ObjectiveStyle style) {
  style_ = style;
  update();
}

void ObjectiveView::examine(std::optional<int> position) {
  const bool there = position && *position < static_cast<int>(data_.positions.size());
  examined_ = there ? position : std::nullopt;
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

void ObjectiveView::pointAt(std::optional<int> position) {
  if (position == hovered_) return;
  hovered_ = position;
  update();
}

void ObjectiveView::mouseMoveEvent(QMouseEvent* event) {
  pointAt(positionAt(event->position(), rect(), data_, style_));
}

void ObjectiveView::mousePressEvent(QMouseEvent* event) {
  const auto position = positionAt(event->position(), rect(), data_, style_);
  if (event->button() == Qt::LeftButton && position) emit positionPicked(*position);
}

void ObjectiveView::leaveEvent(QEvent*) {
  pointAt(std::nullopt);
}

void ObjectiveView::keyPressEvent(QKeyEvent* event) {
  const auto count = static_cast<int>(data_.positions.size());
  const int from = hovered_.value_or(data_.chosen.value_or(0));
  if (count > 0 && event->key() == Qt::Key_Right)
    pointAt((from + 1) % count);
  else if (count > 0 && event->key() == Qt::Key_Left)
    pointAt((from + count - 1) % count);
  else if (hovered_ && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
    emit positionPicked(*hovered_);
  else
    QWidget::keyPressEvent(event);
}

}  // namespace vantage
