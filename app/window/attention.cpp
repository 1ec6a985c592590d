#include "window/attention.h"

#include <QApplication>
#include <QWidget>
#include <utility>

#include "session_controller.h"

namespace vantage {

Attention::Attention(SessionController& controller, QWidget& window)
    : Attention(controller, {[&window] { QApplication::alert(&window); }, [] { QApplication::beep(); }}, &window) {}

Attention::Attention(SessionController& controller, Ways ways, QObject* parent)
    : QObject(parent), controller_(controller), ways_(std::move(ways)) {
  connect(&controller, &SessionController::activityChanged, this, &Attention::look);
}

void Attention::look() {
  const Activity now = controller_.activity();
  const bool scanned = std::exchange(before_, now) == Activity::Running && now == Activity::Idle;
  if (!scanned) return;
  ways_.show();
  if (sound_) ways_.sound();
}

}  // namespace vantage
