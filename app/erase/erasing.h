#pragma once

#include <QObject>

#include "docks/model_pane.h"
#include "erase/erase_bar.h"
#include "erase/erase_desk.h"

namespace vantage {

/// Erasing in a window: its desk, and its row in the pane of the model.
class Erasing final : public QObject {
  Q_OBJECT

 public:
  Erasing(SessionController& controller, JobRunner& jobs, ModelPane& pane, QObject* parent = nullptr);

  /// Shows the row with the tool that was used last. @return why that cannot be done now; empty when it was
  QString start();
  [[nodiscard]] EraseDesk& desk() { return desk_; }
  [[nodiscard]] EraseBar& bar() { return *bar_; }

 signals:
  void refused(const QString& why);

 private:
  EraseDesk desk_;
  EraseBar* bar_;  ///< of the pane
};

}  // namespace vantage
