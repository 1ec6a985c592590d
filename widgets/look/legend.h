#pragma once

#include <QPainter>
#include <QString>
#include <variant>
#include <vector>

#include "look/theme.h"

namespace vantage {

/// A colour scale with its ends, and a unit in words.
struct ScaleLegend {
  QString title;
  QString unit;
  double from = 0.0;
  double to = 1.0;
  ColourMap map = ColourMap::Viridis;
};

/// Colours with what each stands for.
struct KeyLegend {
  struct Entry {
    QColor colour;
    QString text;
  };
  QString title;
  std::vector<Entry> entries;
};

using Legend = std::variant<ScaleLegend, KeyLegend>;

/// What is written over a scene: notes in the top left corner, legends from the bottom right corner upward.
struct Overlay {
  QStringList notes;  ///< the first is the title
  std::vector<Legend> legends;
};

/// A number for the eye: three digits, thousands apart, "0" for nothing.
[[nodiscard]] QString shortNumber(double value);

/// The font of everything that is painted, at a size in device-independent pixels.
[[nodiscard]] QFont pictureFont(double pixels, bool bold = false);

/// The size that a legend takes.
[[nodiscard]] QSizeF legendSize(const Legend& legend);
void paintLegend(QPainter& painter, const QPointF& topLeft, const Legend& legend, const Theme& theme);

/// A colour scale in one line, to the right of it.
void paintScaleLine(QPainter& painter, const QRectF& line, const ScaleLegend& legend, const Theme& theme);

void paintOverlay(QPainter& painter, const QRectF& area, const Overlay& overlay, const Theme& theme);

}  // namespace vantage
