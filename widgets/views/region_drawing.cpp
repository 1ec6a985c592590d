#include "views/region_drawing.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// Corners of a line are no nearer to each other [px].
constexpr double kLeastStep = 3.0;
// A line that covers no more than this was a click [px^2].
constexpr double kLeastCovered = 30.0;
constexpr double kKeyStep = 10.0;
constexpr double kFineKeyStep = 1.0;
const QColor kLineColour(0xD5, 0x5E, 0x00);

double coveredBy(const QPolygonF& corners) {
  double twice = 0.0;
  for (qsizetype i = 0; i < corners.size(); ++i) {
    const QPointF& a = corners[i];
    const QPointF& b = corners[(i + 1) % corners.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * std::abs(twice);
}

QPolygonF rectangleOf(const QPointF& a, const QPointF& b) {
  return QPolygonF(QList<QPointF>{a, {b.x(), a.y()}, b, {a.x(), b.y()}});
}

}  // namespace

RegionDrawing::RegionDrawing(QWidget& view) : QWidget(&view) {
  setObjectName(QStringLiteral("regionDrawing"));
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Draw around what is to be erased"));
  view.installEventFilter(this);
  hide();
}

void RegionDrawing::begin(DrawnShape shape) {
  shape_ = shape;
  clear();
  setCursor(Qt::CrossCursor);
  setGeometry(parentWidget()->rect());
  cross_ = QRectF(rect()).center();
  usesKeys_ = false;
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
}

void RegionDrawing::end() {
  clear();
  hide();
}

void RegionDrawing::clear() {
  line_.clear();
  drawn_.clear();
  pressed_ = false;
  update();
}

bool RegionDrawing::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    const QRectF before = rect();
    setGeometry(parentWidget()->rect());
    follow(before, rect());
  }
  return QWidget::eventFilter(watched, event);
}

// The camera sees as much from top to bottom in a view of any size: what was drawn stays on what it is around.
void RegionDrawing::follow(const QRectF& before, const QRectF& now) {
  if (before.height() <= 0.0 || now.height() <= 0.0) return;
  const double scale = now.height() / before.height();
  const auto moved = [&](const QPointF& p) { return now.center() + scale * (p - before.center()); };
  for (QPointF& p : line_) p = moved(p);
  for (QPointF& p : drawn_) p = moved(p);
  cross_ = moved(cross_);
  update();
}

void RegionDrawing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(kLineColour, 2.0, line_.isEmpty() ? Qt::SolidLine : Qt::DashLine));
  if (!drawn_.isEmpty()) painter.drawPolygon(drawn_);
  if (shape_ == DrawnShape::Rectangle && !line_.isEmpty()) {
    painter.drawPolygon(rectangleOf(line_.front(), usesKeys_ ? cross_ : line_.back()));
  } else if (!line_.isEmpty()) {
    painter.drawPolyline(line_);
    if (usesKeys_) painter.drawLine(line_.back(), cross_);
  }
  if (!usesKeys_) return;
  constexpr double kArm = 9.0;
  painter.setPen(QPen(kLineColour, 2.0));
  painter.drawLine(cross_ - QPointF(kArm, 0.0), cross_ + QPointF(kArm, 0.0));
  painter.drawLine(cross_ - QPointF(0.0, kArm), cross_ + QPointF(0.0, kArm));
}

void RegionDrawing::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier) return event->ignore();
  setFocus(Qt::MouseFocusReason);
  usesKeys_ = false;
  drawn_.clear();
  line_ = QPolygonF(QList<QPointF>{event->position()});
  pressed_ = true;
  update();
}

void RegionDrawing::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return event->ignore();
  reach(event->position());
}

void RegionDrawing::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_ || event->button() != Qt::LeftButton) return event->ignore();
  pressed_ = false;
  reach(event->position());
  close();
}

void RegionDrawing::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
}

void RegionDrawing::reach(const QPointF& point) {
  if (shape_ == DrawnShape::Rectangle)
    line_ = QPolygonF(QList<QPointF>{line_.front(), point});
  else if (QLineF(line_.back(), point).length() >= kLeastStep)
    line_ << point;
  update();
}

void RegionDrawing::close() {
  QPolygonF corners =
      shape_ == DrawnShape::Rectangle && line_.size() > 1 ? rectangleOf(line_.front(), line_.back()) : line_;
  line_.clear();
  update();
  if (corners.size() < 3 || coveredBy(corners) < kLeastCovered) return;
  drawn_ = std::move(corners);
  emit closed();
}

void RegionDrawing::moveCross(const QPointF& by) {
  usesKeys_ = true;
  const QPointF moved = cross_ + by;
  cross_ = {std::clamp(moved.x(), 0.0, width() - 1.0), std::clamp(moved.y(), 0.0, height() - 1.0)};
  update();
}

void RegionDrawing::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() == Qt::ShiftModifier ? kFineKeyStep : kKeyStep;
  switch (event->key()) {
    case Qt::Key_Escape:
      return emit cancelled();
    case Qt::Key_Left:
      return moveCross({-step, 0.0});
    case Qt::Key_Right:
      return moveCross({step, 0.0});
    case Qt::Key_Up:
      return moveCross({0.0, -step});
    case Qt::Key_Down:
      return moveCross({0.0, step});
    case Qt::Key_Space:
      usesKeys_ = true;
      drawn_.clear();
      line_ << cross_;
      return update();
    case Qt::Key_Backspace:
      if (!line_.isEmpty()) line_.removeLast();
      return update();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (line_.isEmpty()) break;
      line_ << cross_;
      return close();
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace vantage
