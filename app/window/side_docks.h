#pragma once

#include <QDockWidget>
#include <QList>
#include <QMainWindow>
#include <QObject>

namespace vantage {

/// Docks that a window does without while it is too narrow for them: they go when it is made narrower than all that it
/// shows needs, and come back with the room.
class SideDocks final : public QObject {
  Q_OBJECT

 public:
  /// @param docks of the window, which outlives this
  SideDocks(QMainWindow& window, QList<QDockWidget*> docks);

  /// Hides or shows them as the width of the window asks for.
  void arrange();
  /// Shows those that went, whatever room there is: before a layout is kept or given back.
  void expand();
  [[nodiscard]] bool collapsed() const { return !gone_.isEmpty(); }
  /// The least width of the window: what it needs without them.
  [[nodiscard]] int leastWidth() const;

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// One that the operator asked for gets its room, where the screen has it.
  void makeRoom();

  QMainWindow& window_;
  QList<QDockWidget*> docks_;
  QList<QDockWidget*> gone_;
  int needed_ = 0;  ///< width at which they come back
  bool arranging_ = false;
};

}  // namespace vantage
