#pragma once

#include <QRectF>
#include <QString>
#include <QWidget>
#include <vector>

namespace vantage::testing {

/// A piece of text that a widget paints, in device-independent pixels of its window.
struct PaintedText {
  QString text;
  QRectF place;  ///< the ink of the text
  QRectF room;   ///< the widget that paints it
  QRectF shown;  ///< the part of the ink that is not scrolled out of sight
};

/// Everything that the visible widgets of a window write; text in pictures is not among it.
[[nodiscard]] std::vector<PaintedText> paintedText(QWidget& window);

/// Texts that reach beyond the widget that paints them.
[[nodiscard]] QStringList cutOff(const std::vector<PaintedText>& texts);

/// Pairs of texts that are written over each other.
[[nodiscard]] QStringList overlapping(const std::vector<PaintedText>& texts);

}  // namespace vantage::testing
