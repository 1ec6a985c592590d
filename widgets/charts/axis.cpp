#include "charts/axis.h"

#include <QFontMetricsF>
#include <cmath>

namespace vantage {

std::vector<double> roundMarks(double maximum, int count) {
  if (!(maximum > 0.0) || count < 1) return {0.0};
  const double raw = maximum / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) {
      step = factor * power;
      break;
    }
  std::vector<double> marks;
  for (int k = 0; k * step <= maximum * (1.0 + 1e-9); ++k) marks.push_back(k * step);
  return marks;
}

void paintText(QPainter& painter, const QPointF& place, Qt::Alignment alignment, const QString& text,
               const QColor& colour, double pixels, bool bold) {
  painter.setFont(pictureFont(pixels, bold));
  painter.setPen(colour);
  const QFontMetricsF metrics(painter.font());
  const QSizeF size(metrics.horizontalAdvance(text) + 2.0, metrics.height());
  QPointF corner = place;
  if (alignment & Qt::AlignHCenter) corner.rx() -= 0.5 * size.width();
  if (alignment & Qt::AlignRight) corner.rx() -= size.width();
  if (alignment & Qt::AlignVCenter) corner.ry() -= 0.5 * size.height();
  if (alignment & Qt::AlignBottom) corner.ry() -= size.height();
  painter.drawText(QRectF(corner, size), Qt::AlignCenter, text);
}

}  // namespace vantage
