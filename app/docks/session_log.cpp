#include "docks/session_log.h"

#include <QFileInfo>
#include <utility>

#include "docks/log_panel.h"

namespace vantage {

SessionLog::SessionLog(SessionController& controller, LogPanel& panel)
    : QObject(&panel), controller_(controller), panel_(panel) {
  connect(&controller, &SessionController::sessionChanged, this, &SessionLog::opened);
  connect(&controller, &SessionController::stateChanged, this, &SessionLog::changed);
  connect(&controller, &SessionController::message, &panel, &LogPanel::add);
  connect(&controller, &SessionController::failed, &panel, &LogPanel::addError);
  connect(&controller, &SessionController::written, &panel,
          [&panel](const QString& path) { panel.add(tr("Written: %1").arg(path)); });
}

QString SessionLog::textOf(int moment) const {
  const auto& moments = controller_.present().moments();
  return moment >= 0 && moment < static_cast<int>(moments.size()) ? moments[static_cast<std::size_t>(moment)].text
                                                                  : QString();
}

// Its moments follow.
void SessionLog::opened() {
  cursor_ = -1;
  moments_ = 0;
  if (controller_.hasSession()) panel_.add(tr("Session: %1").arg(controller_.sessionPath()));
}

void SessionLog::changed() {
  if (!controller_.hasSession() || !controller_.now()) return;
  const Present& present = controller_.present();
  const int before = std::exchange(cursor_, present.cursor());
  const std::size_t known = std::exchange(moments_, present.moments().size());
  if (before < 0 && present.cursor() > 0)
    return panel_.add(
        tr("Opened after %1 steps; the last one: %2").arg(present.cursor()).arg(textOf(present.cursor())));
  if (before > present.cursor() && known == moments_) {
    for (int moment = before; moment > present.cursor(); --moment) panel_.add(tr("Undone: %1").arg(textOf(moment)));
    return;
  }
  const bool redone = before >= 0 && before < present.cursor() && known == moments_;
  if (redone) return panel_.add(tr("Redone: %1").arg(textOf(present.cursor())));
  if (before != present.cursor() || known != moments_) panel_.add(textOf(present.cursor()));
}

}  // namespace vantage
