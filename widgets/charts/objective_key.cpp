#include "charts/objective_key.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>

#include "charts/axis.h"
#include "look/legend.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ObjectiveView)
};

// What the colours and lines stand for, along the lower border.
void paintFoot(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, const Theme& theme) {
  struct Item {
    QColor colour;
    QString text;
    bool line;
  };
  const std::array<Item, 4> items{
      {{objectiveVoidColour(), Text::tr("o_v: would show"), false},
       {theme.threshold, Text::tr("F = %1").arg(shortArea(data.terminationThreshold)), true},
       {objectiveOverlapColour(), Text::tr("o_s: overlap"), false},
       {theme.threshold, Text::tr("t = %1").arg(shortArea(data.leastOverlap)), true}}};
  const double width = (area.width() - 20.0) / 2.0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double x = area.left() + 10.0 + width * static_cast<double>(i % 2);
    const std::size_t line = i / 2;
    const double y = area.bottom() - kObjectiveKeyHeight + 10.0 + 17.0 * static_cast<double>(line);
    if (items[i].line) {
      painter.setPen(QPen(items[i].colour, 1.5, i == 1 ? Qt::DashLine : Qt::DotLine));
      painter.drawLine(QPointF(x, y), QPointF(x + 16.0, y));
    } else {
      painter.fillRect(QRectF(x, y - 5.0, 16.0, 10.0), items[i].colour);
    }
    paintText(painter, {x + 22.0, y}, Qt::AlignLeft | Qt::AlignVCenter, items[i].text, theme.text);
  }
}

// What the arrows mean, and pale bars, in one line below.
void paintMarkKey(QPainter& painter, const QRectF& area, const Theme& theme) {
  struct Item {
    QColor colour;
    QString text;
  };
  const std::array<Item, 4> items{{{theme.current, Text::tr("now")},
                                   {theme.proposed, Text::tr("next")},
                                   {theme.examined, Text::tr("asked")},
                                   {objectiveShade(objectiveVoidColour(), false), Text::tr("ruled out")}}};
  constexpr double kPixels = 11.0;
  constexpr double kMark = 14.0;
  constexpr double kLeastGap = 6.0;
  const QFontMetricsF metrics(pictureFont(kPixels));
  double texts = 0.0;
  for (const Item& item : items) texts += metrics.horizontalAdvance(item.text) + 2.0;
  // Smaller where a language has no room, else as far apart as there is.
  const double room = area.width() - 20.0 - 4.0 * kMark;
  const double scale = std::min(1.0, (room - 3.0 * kLeastGap) / texts);
  const double gap = (room - scale * texts) / 3.0;
  const double y = area.bottom() - 12.0;
  double x = area.left() + 10.0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(items[i].colour);
    if (i < 3) {
      painter.drawPolygon(QPolygonF({{x, y + 4.0}, {x + 10.0, y + 4.0}, {x + 5.0, y - 5.0}}));
    } else {
      painter.drawRect(QRectF(x, y - 5.0, 10.0, 10.0));
    }
    paintText(painter, {x + kMark, y}, Qt::AlignLeft | Qt::AlignVCenter, items[i].text, theme.text,
              std::floor(scale * kPixels));
    x += kMark + scale * (metrics.horizontalAdvance(items[i].text) + 2.0) + gap;
  }
}

}  // namespace

QColor objectiveVoidColour() {
  return toColour(categoryColour(1));
}

QColor objectiveOverlapColour() {
  return toColour(categoryColour(0));
}

QColor objectiveShade(QColor colour, bool allowed) {
  if (!allowed) colour.setAlphaF(0.35F);
  return colour;
}

QString shortArea(double squareMillimetres) {
  return shortNumber(squareMillimetres) + QStringLiteral(" mm²");
}

void paintObjectiveKey(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, const Theme& theme) {
  paintFoot(painter, area, data, theme);
  paintMarkKey(painter, area, theme);
}

}  // namespace vantage
