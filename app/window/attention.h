#pragma once

#include <QObject>
#include <functional>

#include "undertaking.h"

class QWidget;

namespace vantage {

class SessionController;

/// Calls the operator, who may be elsewhere, when scanning has ended or waits for somebody: once each time, and not
/// when it was the operator who stopped it.
class Attention final : public QObject {
  Q_OBJECT

 public:
  /// How somebody is called.
  struct Ways {
    std::function<void()> show;   ///< in the task bar, where the window is not the active one
    std::function<void()> sound;  ///< where it is wanted
  };

  /// @param window that is to be looked at
  Attention(SessionController& controller, QWidget& window);
  Attention(SessionController& controller, Ways ways, QObject* parent = nullptr);

  void setSound(bool wanted) { sound_ = wanted; }

 private:
  void look();

  SessionController& controller_;
  Ways ways_;
  Activity before_ = Activity::Idle;
  bool sound_ = true;
};

}  // namespace vantage
