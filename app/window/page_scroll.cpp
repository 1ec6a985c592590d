#include "window/page_scroll.h"

#include <QEvent>

namespace vantage {

PageScroll::PageScroll(QWidget* page, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setWidget(page);
}

// Qt asks this of a widget that is disabled or hidden while it has the keyboard, too.
bool PageScroll::focusNextPrevChild(bool next) {
  QWidget* focused = window()->focusWidget();
  const bool asked = focused == nullptr || (focused->isEnabled() && focused->isVisible());
  if (asked) return QScrollArea::focusNextPrevChild(next);
  waitFor(focused);
  return false;
}

void PageScroll::waitFor(QWidget* widget) {
  if (disabled_) disabled_->removeEventFilter(this);
  disabled_ = widget;
  widget->installEventFilter(this);
}

bool PageScroll::eventFilter(QObject* watched, QEvent* event) {
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
