#include "look/legend.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double kText = 12.0;  // height of the font [px]
constexpr double kPadding = 8.0;
constexpr double kLine = 17.0;
constexpr double kBarLength = 150.0;
constexpr double kBarHeight = 12.0;
constexpr double kSwatch = 11.0;
constexpr double kMargin = 10.0;
constexpr int kGradientStops = 32;

double textWidth(const QString& text, bool bold) {
  return QFontMetricsF(pictureFont(kText, bold)).horizontalAdvance(text);
}

QSizeF sizeOf(const ScaleLegend& legend) {
  const double ends = textWidth(shortNumber(legend.from), false) +
                      textWidth(shortNumber(legend.to) + " " + legend.unit, false) + 3.0 * kPadding;
  return {std::max({kBarLength, textWidth(legend.title, true), ends}) + 2.0 * kPadding,
          2.0 * kLine + kBarHeight + 2.0 * kPadding};
}

QSizeF sizeOf(const KeyLegend& legend) {
  double width = textWidth(legend.title, true);
  for (const auto& entry : legend.entries) width = std::max(width, kSwatch + kPadding + textWidth(entry.text, false));
  return {width + 2.0 * kPadding + 2.0, kLine * static_cast<double>(legend.entries.size() + 1) + 2.0 * kPadding - 2.0};
}

void write(QPainter& painter, const QRectF& area, int flags, const QString& text, const QColor& colour, bool bold) {
  painter.setFont(pictureFont(kText, bold));
  painter.setPen(colour);
  painter.drawText(area, flags, text);
}

void paintGradient(QPainter& painter, const QRectF& bar, ColourMap map, const Theme& theme) {
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int i = 0; i <= kGradientStops; ++i) {
    const double at = static_cast<double>(i) / kGradientStops;
    gradient.setColorAt(at, toColour(colourAt(map, at)));
  }
  painter.setPen(QPen(theme.grid, 1.0));
  painter.setBrush(gradient);
  painter.drawRect(bar);
}

void paint(QPainter& painter, const QRectF& inner, const ScaleLegend& legend, const Theme& theme) {
  write(painter, {inner.topLeft(), QSizeF(inner.width(), kLine)}, Qt::AlignLeft | Qt::AlignVCenter, legend.title,
        theme.text, true);
  const QRectF bar(inner.left(), inner.top() + kLine + 1.0, inner.width(), kBarHeight);
  paintGradient(painter, bar, legend.map, theme);
  const QRectF ends(inner.left(), bar.bottom() + 2.0, inner.width(), kLine);
  write(painter, ends, Qt::AlignLeft | Qt::AlignVCenter, shortNumber(legend.from), theme.text, false);
  write(painter, ends, Qt::AlignRight | Qt::AlignVCenter, shortNumber(legend.to) + " " + legend.unit, theme.text,
        false);
}

void paint(QPainter& painter, const QRectF& inner, const KeyLegend& legend, const Theme& theme) {
  QRectF line(inner.topLeft(), QSizeF(inner.width(), kLine));
  write(painter, line, Qt::AlignLeft | Qt::AlignVCenter, legend.title, theme.text, true);
  for (const auto& entry : legend.entries) {
    line.translate(0.0, kLine);
    painter.setPen(QPen(theme.grid, 1.0));
    painter.setBrush(entry.colour);
    painter.drawRect(QRectF(line.left() + 0.5, line.center().y() - 0.5 * kSwatch, kSwatch, kSwatch));
    write(painter, line.adjusted(kSwatch + kPadding, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, entry.text,
          theme.text, false);
  }
}

void paintNotes(QPainter& painter, const QRectF& area, const QStringList& notes, const Theme& theme) {
  // A light ground, so that the notes can be read over anything.
  double width = 0.0;
  for (int i = 0; i < notes.size(); ++i) width = std::max(width, textWidth(notes[i], i == 0));
  QColor ground = theme.panel;
  ground.setAlphaF(0.7F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  if (!notes.isEmpty())
    painter.drawRoundedRect(QRectF(area.left() + 4.0, area.top() + 4.0, std::min(width + 12.0, area.width() - 8.0),
                                   kLine * static_cast<double>(notes.size()) + 8.0),
                            4.0, 4.0);
  QRectF line(area.left() + kMargin, area.top() + kMargin - 2.0, area.width() - 2.0 * kMargin, kLine);
  for (int i = 0; i < notes.size(); ++i) {
    const QFontMetricsF metrics(pictureFont(kText, i == 0));
    write(painter, line, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(notes[i], Qt::ElideRight, line.width()),
          i == 0 ? theme.text : theme.mutedText, i == 0);
    line.translate(0.0, kLine);
  }
}

}  // namespace

QString shortNumber(double value) {
  const double size = std::abs(value);
  if (size == 0.0) return QStringLiteral("0");
  const bool whole = size == std::floor(size);
  const int digits = whole || size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
  QString text = QString::number(value, 'f', digits);
  // A thin space every three digits: commas and points mean different things in different places.
  const int point = static_cast<int>(text.indexOf('.') < 0 ? text.size() : text.indexOf('.'));
  for (int i = point - 3; i > (value < 0.0 ? 1 : 0); i -= 3) text.insert(i, QChar(0x2009));
  return text.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

QFont pictureFont(double pixels, bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(pixels)));
  font.setBold(bold);
  return font;
}

QSizeF legendSize(const Legend& legend) {
  return std::visit([](const auto& l) { return sizeOf(l); }, legend);
}

void paintLegend(QPainter& painter, const QPointF& topLeft, const Legend& legend, const Theme& theme) {
  const QRectF box(topLeft, legendSize(legend));
  QColor panel = theme.panel;
  panel.setAlphaF(0.88F);
  painter.setPen(QPen(theme.grid, 1.0));
  painter.setBrush(panel);
  painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  const QRectF inner = box.adjusted(kPadding, kPadding - 2.0, -kPadding, -kPadding);
  std::visit([&](const auto& l) { paint(painter, inner, l, theme); }, legend);
}

void paintScaleLine(QPainter& painter, const QRectF& line, const ScaleLegend& legend, const Theme& theme) {
  const QString most = shortNumber(legend.to) + " " + legend.unit + ", " + legend.title;
  const double right = line.right() - textWidth(most, false) - 2.0;
  const double length = std::clamp(right - line.left() - 30.0, 0.0, kBarLength);
  write(painter, line, Qt::AlignRight | Qt::AlignVCenter, most, theme.text, false);
  const QRectF bar(right - 6.0 - length, line.center().y() - 0.5 * kBarHeight, length, kBarHeight);
  paintGradient(painter, bar, legend.map, theme);
  write(painter, QRectF(line.left(), line.top(), bar.left() - 6.0 - line.left(), line.height()),
        Qt::AlignRight | Qt::AlignVCenter, shortNumber(legend.from), theme.text, false);
}

void paintOverlay(QPainter& painter, const QRectF& area, const Overlay& overlay, const Theme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  paintNotes(painter, area, overlay.notes, theme);
  double bottom = area.bottom() - kMargin;
  for (const Legend& legend : overlay.legends) {
    const QSizeF size = legendSize(legend);
    // A legend that does not fit says less than the picture it would cover.
    if (bottom - size.height() < area.top() + kMargin || size.width() > 0.6 * area.width()) continue;
    paintLegend(painter, {area.right() - kMargin - size.width(), bottom - size.height()}, legend, theme);
    bottom -= size.height() + 0.5 * kMargin;
  }
}

}  // namespace vantage
