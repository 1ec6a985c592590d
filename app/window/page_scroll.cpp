#include "window/page_scroll.h"

#include <QApplication>
#include <QKeyEvent>
#include <utility>

namespace vantage {

PageScroll::PageScroll(QWidget* page, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setWidget(page);
  qApp->installEventFilter(this);
}

// Qt asks this also of a widget that is about to be disabled or hidden while it has the keyboard.
bool PageScroll::focusNextPrevChild(bool next) {
  QWidget* focused = window()->focusWidget();
  if (std::exchange(tabbing_, false) || focused == nullptr) return QScrollArea::focusNextPrevChild(next);
  waitFor(focused);
  return false;
}

void PageScroll::waitFor(QWidget* widget) {
  if (disabled_) disabled_->removeEventFilter(this);
  disabled_ = widget;
  widget->installEventFilter(this);
}

bool PageScroll::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<const QKeyEvent*>(event)->key();
    tabbing_ = key == Qt::Key_Tab || key == Qt::Key_Backtab;
  } else if (event->type() == QEvent::MouseButtonPress) {
    tabbing_ = false;
  }
  const bool again = watched == disabled_ && (event->type() == QEvent::EnabledChange || event->type() == QEvent::Show);
  if (again && disabled_->isEnabled() && disabled_->isVisible()) {
    QWidget* widget = disabled_;
    widget->removeEventFilter(this);
    disabled_.clear();
    if (window()->focusWidget() == nullptr) widget->setFocus(Qt::OtherFocusReason);
  }
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace vantage
