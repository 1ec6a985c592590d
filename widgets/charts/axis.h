#pragma once

#include <QPainter>
#include <vector>

#include "look/legend.h"

namespace vantage {

/// Round numbers from 0 up to no more than `maximum`, about `count` of them; {0} when there is nothing to mark.
[[nodiscard]] std::vector<double> roundMarks(double maximum, int count);

/// Text in a small font about a place. @param alignment where the place is: AlignLeft puts the text to its right.
void paintText(QPainter& painter, const QPointF& place, Qt::Alignment alignment, const QString& text,
               const QColor& colour, double pixels = 11.0, bool bold = false);

}  // namespace vantage
