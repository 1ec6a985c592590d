#include "wizard/turn_dial.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "why_card.h"

namespace vantage {
namespace {

QPointF onCircle(const QPointF& centre, double radius, double angle) {
  return centre + QPointF(radius * std::cos(angle), -radius * std::sin(angle));
}

void drawArrowHead(QPainter& painter, const QPointF& tip, double heading) {
  const QPointF back(std::cos(heading), -std::sin(heading));
  const QPointF side(-back.y(), back.x());
  const QPointF corners[] = {tip + 9.0 * back, tip - 4.0 * back + 6.0 * side, tip - 4.0 * back - 6.0 * side};
  painter.drawPolygon(corners, 3);
}

}  // namespace

TurnDial::TurnDial(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(160);
}

void TurnDial::show(double current, double target, double turn) {
  shown_ = true;
  current_ = current;
  target_ = target;
  turn_ = turn;
  setAccessibleName(tr("Turn the table by %1").arg(angleText(turn)));
  update();
}

void TurnDial::clear() {
  shown_ = false;
  update();
}

void TurnDial::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF centre(width() / 2.0, height() / 2.0);
  const double radius = std::min(width(), height()) / 2.0 - 26.0;
  const QColor text = palette().color(QPalette::WindowText);
  const QColor accent = palette().color(QPalette::Highlight);
  painter.setPen(QPen(text, 1.5));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawEllipse(centre, radius, radius);
  painter.setPen(QPen(text, 1.0));
  for (int i = 0; i < 24; ++i)
    painter.drawLine(onCircle(centre, radius - (i % 6 == 0 ? 8 : 4), i * M_PI / 12),
                     onCircle(centre, radius, i * M_PI / 12));
  if (!shown_) return;
  // The scanner stands still at `current`; the spot of the table that it shall see comes round to it from `target`.
  painter.setPen(QPen(text, 2.0));
  painter.drawLine(onCircle(centre, radius + 4, current_), onCircle(centre, radius + 16, current_));
  painter.setPen(Qt::NoPen);
  painter.setBrush(text);
  drawArrowHead(painter, onCircle(centre, radius + 11, current_), current_ + M_PI);
  painter.setBrush(accent);
  painter.drawEllipse(onCircle(centre, radius - 14, target_), 6.0, 6.0);
  if (std::abs(turn_) < 1e-6) return;
  const double sweep = radius * 0.62;
  const QRectF box(centre.x() - sweep, centre.y() - sweep, 2 * sweep, 2 * sweep);
  QPainterPath arc;
  arc.arcMoveTo(box, target_ * 180 / M_PI);
  arc.arcTo(box, target_ * 180 / M_PI, turn_ * 180 / M_PI);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(accent, 4.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawPath(arc);
  painter.setPen(Qt::NoPen);
  painter.setBrush(accent);
  const double end = target_ + turn_;
  drawArrowHead(painter, onCircle(centre, sweep, end), end + (turn_ > 0 ? M_PI / 2 : -M_PI / 2));
  painter.setPen(text);
  painter.drawText(QRectF(centre.x() - 50, centre.y() - 12, 100, 24), Qt::AlignCenter, angleText(std::abs(turn_)));
}

}  // namespace vantage
