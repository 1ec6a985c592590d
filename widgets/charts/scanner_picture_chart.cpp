#include "charts/scanner_picture_chart.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "charts/axis.h"
#include "look/figures.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ScannerPicture)
};

QColor colourOf(RaySight sight, double cosine, const Theme& theme) {
  switch (sight) {
    case RaySight::Surface:
      return QColor::fromRgbF(theme.surface.redF() * static_cast<float>(cosine),
                              theme.surface.greenF() * static_cast<float>(cosine),
                              theme.surface.blueF() * static_cast<float>(cosine));
    case RaySight::TooSteep:
      return toColour(categoryColour(3));
    case RaySight::ReceiverBlocked:
      return toColour(categoryColour(2));
    case RaySight::Void:
      return toColour(categoryColour(1));
    case RaySight::Back:
      return toColour(categoryColour(0));
    case RaySight::Nothing:
      break;
  }
  return theme.backgroundBottom;
}

const char* textOf(RaySight sight) {
  switch (sight) {
    case RaySight::Surface:
      return QT_TRANSLATE_NOOP("ScannerPicture", "surface");
    case RaySight::TooSteep:
      return QT_TRANSLATE_NOOP("ScannerPicture", "too steep");
    case RaySight::ReceiverBlocked:
      return QT_TRANSLATE_NOOP("ScannerPicture", "receiver blocked");
    case RaySight::Void:
      return QT_TRANSLATE_NOOP("ScannerPicture", "void");
    case RaySight::Back:
      return QT_TRANSLATE_NOOP("ScannerPicture", "inside");
    case RaySight::Nothing:
      break;
  }
  return QT_TRANSLATE_NOOP("ScannerPicture", "nothing");
}

// The rays that meet something, with some room around them; all where none does.
QRect filledPart(const ScannerPicture& picture) {
  constexpr double kAround = 0.08;
  QRect filled;
  for (int row = 0; row < picture.rows; ++row)
    for (int column = 0; column < picture.columns; ++column)
      if (picture.sight[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.columns) +
                        static_cast<std::size_t>(column)] != RaySight::Nothing)
        filled |= QRect(picture.columnsLeft ? picture.columns - 1 - column : column,
                        picture.rowsUp ? picture.rows - 1 - row : row, 1, 1);
  const QRect whole(0, 0, picture.columns, picture.rows);
  if (filled.isEmpty()) return whole;
  const int around = 2 + static_cast<int>(kAround * std::max(filled.width(), filled.height()));
  return filled.adjusted(-around, -around, around, around) & whole;
}

// The classes that occur, in as few lines as they fit in. @return the height they took
double paintKey(QPainter& painter, const QRectF& area, const ScannerPicture& picture, const Theme& theme, bool draw) {
  constexpr double kLine = 17.0;
  QPointF at(area.left() + 10.0, area.bottom() - 6.0 - 0.5 * kLine);
  double height = kLine;
  // What passes by says nothing: of the rays that meet something it is told what they meet.
  const std::size_t meeting = std::max<std::size_t>(1, picture.sight.size() - picture.count(RaySight::Nothing));
  for (std::size_t k = 0; k < kRaySights; ++k) {
    const auto sight = static_cast<RaySight>(k);
    const std::size_t count = sight == RaySight::Nothing ? 0 : picture.count(sight);
    if (count == 0) continue;
    const QString label = QStringLiteral("%1 %2 %").arg(
        Text::tr(textOf(sight)), figureText(100.0 * static_cast<double>(count) / static_cast<double>(meeting), 1));
    const double width = 16.0 + QFontMetricsF(pictureFont(11.0)).horizontalAdvance(label) + 14.0;
    if (at.x() + width > area.right() && at.x() > area.left() + 10.0) {
      at = QPointF(area.left() + 10.0, at.y() - kLine);
      height += kLine;
    }
    if (draw) {
      painter.setPen(QPen(theme.grid, 1.0));
      painter.setBrush(colourOf(sight, 0.9, theme));
      painter.drawRect(QRectF(at.x(), at.y() - 5.0, 10.0, 10.0));
      paintText(painter, at + QPointF(15.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, label, theme.text);
    }
    at.rx() += width;
  }
  return height;
}

}  // namespace

QImage toImage(const ScannerPicture& picture, const Theme& theme) {
  QImage image(picture.columns, picture.rows, QImage::Format_RGB32);
  for (int row = 0; row < picture.rows; ++row)
    for (int column = 0; column < picture.columns; ++column) {
      const auto i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.columns) + static_cast<std::size_t>(column);
      const QColor colour = colourOf(picture.sight[i], static_cast<double>(picture.cosine[i]), theme);
      image.setPixelColor(picture.columnsLeft ? picture.columns - 1 - column : column,
                          picture.rowsUp ? picture.rows - 1 - row : row, colour);
    }
  return image;
}

void paintScannerPicture(QPainter& painter, const QRectF& area, const ScannerPicture& picture, const QString& title,
                         const Theme& theme) {
  constexpr double kTop = 32.0;
  painter.fillRect(area, theme.panel);
  paintOverlay(painter, area, {{title}, {}}, theme);
  const double key = paintKey(painter, area, picture, theme, false);
  const QRectF room = area.adjusted(10.0, kTop, -10.0, -key - 14.0);
  const QImage image = toImage(picture, theme).copy(filledPart(picture));
  const QSizeF size = QSizeF(image.size()).scaled(room.size(), Qt::KeepAspectRatio);
  const QRectF place(room.center() - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.drawImage(place, image);
  painter.setPen(QPen(theme.grid, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(place);
  paintKey(painter, area, picture, theme, true);
}

}  // namespace vantage
