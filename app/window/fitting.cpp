#include "window/fitting.h"

#include <QScreen>
#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace vantage {
namespace {

// Before a window is shown nobody knows how large its frame is.
QMargins frameOf(const QWidget& window) {
  const QRect inner = window.geometry();
  const QRect outer = window.frameGeometry();
  if (outer != inner)
    return {inner.left() - outer.left(), inner.top() - outer.top(), outer.right() - inner.right(),
            outer.bottom() - inner.bottom()};
  return {1, window.style()->pixelMetric(QStyle::PM_TitleBarHeight), 1, 1};
}

}  // namespace

QRect fittedInto(const QRect& wanted, const QRect& room) {
  const QSize size = wanted.size().boundedTo(room.size());
  const int x = std::clamp(wanted.x(), room.x(), room.x() + room.width() - size.width());
  const int y = std::clamp(wanted.y(), room.y(), room.y() + room.height() - size.height());
  return {QPoint(x, y), size};
}

void fitToScreen(QWidget& window) {
  if (window.screen() == nullptr) return;
  const QRect room = window.screen()->availableGeometry().marginsRemoved(frameOf(window));
  const QRect fitted = fittedInto(window.geometry(), room);
  if (fitted != window.geometry()) window.setGeometry(fitted);
}

}  // namespace vantage
