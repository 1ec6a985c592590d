#pragma once

#include <QObject>

class QKeyEvent;

namespace vantage {

class SessionController;

/// The keys that stop whatever is under way, in every window and dialog of the program: Esc, unless a menu or list is
/// open that it closes, and Shift+F5. While nothing is under way they are as always.
class StopKeys final : public QObject {
  Q_OBJECT

 public:
  StopKeys(SessionController& controller, QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] bool stops(const QKeyEvent& event) const;

  SessionController& controller_;
};

}  // namespace vantage
