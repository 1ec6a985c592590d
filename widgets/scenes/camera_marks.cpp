#include "scenes/camera_marks.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "charts/axis.h"

namespace vantage {
namespace {

constexpr double kMargin = 14.0;
constexpr double kAxis = 24.0;
constexpr double kMostBar = 120.0;
constexpr double kLeastWidth = 260.0;  // of a picture that has room for them

struct Axis {
  Vec3 direction;
  const char* name;
  QColor colour;
};

}  // namespace

double scaleBarLength(double perPixel, double mostPixels) {
  const double most = perPixel * mostPixels;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= most) return step * decade;
  return decade;
}

void paintCameraMarks(QPainter& painter, const QRectF& area, const Camera& camera, const Theme& theme) {
  if (area.width() < kLeastWidth || area.height() < kLeastWidth) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const Vec3 right = camera.right();
  const Vec3 up = right.cross(camera.forward());
  const QPointF origin(area.left() + kMargin + kAxis + 6.0, area.bottom() - kMargin - kAxis - 10.0);
  std::array<Axis, 3> axes{{{Vec3::UnitX(), "x", toColour(categoryColour(1))},
                            {Vec3::UnitY(), "y", toColour(categoryColour(2))},
                            {Vec3::UnitZ(), "z", theme.current}}};
  // The farthest first, so that the nearest lies over it.
  std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
    return a.direction.dot(camera.forward()) > b.direction.dot(camera.forward());
  });
  for (const Axis& axis : axes) {
    const QPointF along(axis.direction.dot(right), -axis.direction.dot(up));
    painter.setPen(QPen(axis.colour, 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, origin + kAxis * along);
    paintText(painter, origin + (kAxis + 9.0) * along, Qt::AlignHCenter | Qt::AlignVCenter,
              QString::fromLatin1(axis.name), theme.text, 11.0, true);
  }
  const double perPixel = 2.0 * camera.distance() * std::tan(0.5 * camera.viewAngle) / area.height();
  const double length = scaleBarLength(perPixel, kMostBar);
  const double left = origin.x() + kAxis + 26.0;
  const double y = area.bottom() - kMargin;
  const double end = left + length / perPixel;
  painter.setPen(QPen(theme.text, 1.5));
  painter.drawLine(QPointF(left, y), QPointF(end, y));
  for (const double x : {left, end}) painter.drawLine(QPointF(x, y - 4.0), QPointF(x, y + 4.0));
  paintText(painter, {0.5 * (left + end), y - 4.0}, Qt::AlignHCenter | Qt::AlignBottom,
            QLocale().toString(length, 'g', QLocale::FloatingPointShortest) + QStringLiteral(" mm"), theme.text);
  painter.restore();
}

}  // namespace vantage
