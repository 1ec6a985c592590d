#include "window/side_docks.h"

#include <QAction>
#include <QEvent>
#include <QLayout>
#include <QScopedValueRollback>
#include <QScreen>
#include <QStyle>
#include <algorithm>
#include <utility>

namespace vantage {

SideDocks::SideDocks(QMainWindow& window, QList<QDockWidget*> docks)
    : QObject(&window), window_(window), docks_(std::move(docks)) {
  window.installEventFilter(this);
  for (QDockWidget* dock : docks_)
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
      gone_.removeAll(dock);
      if (shown) makeRoom();
    });
}

bool SideDocks::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && (event->type() == QEvent::Resize || event->type() == QEvent::Show)) arrange();
  return QObject::eventFilter(watched, event);
}

int SideDocks::leastWidth() const {
  int sides = 0;
  for (const QDockWidget* dock : docks_)
    if (!dock->isHidden() && !dock->isFloating()) sides = std::max(sides, dock->minimumSizeHint().width());
  const int separator = window_.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, &window_);
  const int all = window_.layout()->totalMinimumSize().width();
  return sides == 0 ? all : all - sides - separator;
}

void SideDocks::arrange() {
  if (arranging_ || !window_.isVisible()) return;
  const QScopedValueRollback busy(arranging_, true);
  if (!gone_.isEmpty()) {
    if (window_.width() >= needed_) expand();
    return;
  }
  const int needed = window_.layout()->totalMinimumSize().width();
  if (window_.width() >= needed) return;
  needed_ = needed;
  for (QDockWidget* dock : docks_) {
    if (dock->isHidden() || dock->isFloating()) continue;
    gone_ << dock;
    dock->hide();
  }
}

void SideDocks::expand() {
  for (QDockWidget* dock : std::exchange(gone_, {})) dock->show();
}

void SideDocks::makeRoom() {
  const int needed = window_.layout()->totalMinimumSize().width();
  if (window_.width() >= needed || window_.screen() == nullptr) return;
  const QScopedValueRollback busy(arranging_, true);
  const int most = window_.screen()->availableGeometry().width();
  window_.resize(std::max(window_.width(), std::min(needed, most)), window_.height());
}

}  // namespace vantage
