#pragma once

#include <QRect>

class QWidget;

namespace vantage {

/// A place inside of a room that is as near to the wanted one as can be: where that is larger it is made smaller.
[[nodiscard]] QRect fittedInto(const QRect& wanted, const QRect& room);

/// Puts a window, with its frame, inside of what its screen has to give.
void fitToScreen(QWidget& window);

}  // namespace vantage
