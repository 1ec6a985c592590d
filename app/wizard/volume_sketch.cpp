#include "wizard/volume_sketch.h"

#include <QPainter>
#include <algorithm>

#include "why_card.h"

namespace vantage {
namespace {

constexpr double kMargin = 24.0;
const QColor kOutside(0xD0, 0x3A, 0x3A);  // what reaches out of the volume

}  // namespace

VolumeSketch::VolumeSketch(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(170);
  setAccessibleName(tr("Object in the viewing volume"));
}

void VolumeSketch::show(const SharedSetUp& setUp) {
  setUp_ = setUp;
  update();
}

void VolumeSketch::paintEvent(QPaintEvent* /*event*/) {
  if (!setUp_ || !setUp_->profile) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ViewingVolume& volume = setUp_->profile->viewingVolume;
  const ObjectOnTable object = setUp_->object.value_or(ObjectOnTable());
  const double widest = std::max(volume.radius, object.radius);
  const double highest = std::max(volume.height, object.height);
  const double scale = std::min((width() - 2 * kMargin) / (2 * widest), (height() - 2 * kMargin) / highest);
  const QPointF foot(width() / 2.0, height() - kMargin);
  const auto box = [&](double radius, double low, double high) {
    return QRectF(foot.x() - radius * scale, foot.y() - high * scale, 2 * radius * scale, (high - low) * scale);
  };
  const QColor text = palette().color(QPalette::WindowText);
  painter.setPen(QPen(text, 1.0, Qt::DashLine));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRect(box(volume.radius, 0.0, volume.height));
  painter.setPen(Qt::NoPen);
  QColor fill = object.insideVolume ? palette().color(QPalette::Highlight) : kOutside;
  fill.setAlphaF(0.55F);
  painter.setBrush(fill);
  painter.drawRect(box(object.radius, object.lowest, object.height));
  painter.setPen(QPen(text, 1.0, Qt::DashDotLine));
  painter.drawLine(foot, foot - QPointF(0, highest * scale + 8));
  painter.setPen(QPen(text, 2.0));
  painter.drawLine(foot - QPointF(widest * scale + 8, 0), foot + QPointF(widest * scale + 8, 0));
  painter.setPen(text);
  painter.drawText(QRectF(0, height() - kMargin + 3, width(), kMargin - 3), Qt::AlignHCenter | Qt::AlignTop,
                   tr("⌀ %1 mm, %2 mm high").arg(figureText(2 * volume.radius), figureText(volume.height)));
}

}  // namespace vantage
