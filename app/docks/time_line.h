#pragma once

#include <QListWidget>

#include "session_controller.h"

namespace vantage {

/// The moments of a session from left to right; clicking one shows the session as it was then. Moments that were undone
/// are struck out until something new is done.
class TimeLine final : public QListWidget {
  Q_OBJECT

 public:
  explicit TimeLine(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override { return {600, 78}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 74}; }

 private:
  void refresh();
  void mark();

  SessionController& controller_;
};

}  // namespace vantage
