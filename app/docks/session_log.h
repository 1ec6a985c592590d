#pragma once

#include <QObject>

#include "session_controller.h"

namespace vantage {

class LogPanel;

/// Writes down what is done to a session, as it is done: also that something was undone, and what.
class SessionLog final : public QObject {
  Q_OBJECT

 public:
  SessionLog(SessionController& controller, LogPanel& panel);

 private:
  void opened();
  void changed();
  [[nodiscard]] QString textOf(int moment) const;

  SessionController& controller_;
  LogPanel& panel_;
  int cursor_ = 0;
  std::size_t moments_ = 0;
};

}  // namespace vantage
