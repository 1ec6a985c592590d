#include "window/stop_keys.h"

#include <QApplication>
#include <QKeyEvent>

#include "session_controller.h"

namespace vantage {

StopKeys::StopKeys(SessionController& controller, QObject* parent) : QObject(parent), controller_(controller) {
  qApp->installEventFilter(this);
}

bool StopKeys::stops(const QKeyEvent& event) const {
  if (controller_.idle()) return false;
  if (event.key() == Qt::Key_F5) return event.modifiers() == Qt::ShiftModifier;
  return event.key() == Qt::Key_Escape && event.modifiers() == Qt::NoModifier &&
         QApplication::activePopupWidget() == nullptr;
}

bool StopKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool asks = event->type() == QEvent::ShortcutOverride;
  if (!asks && event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
  if (!stops(static_cast<const QKeyEvent&>(*event))) return QObject::eventFilter(watched, event);
  // First it is asked whether the key is a shortcut: here it is none.
  event->accept();
  if (!asks && controller_.activity() != Activity::Stopping) controller_.stop();
  return true;
}

}  // namespace vantage
