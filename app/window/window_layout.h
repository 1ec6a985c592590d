#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QList>

#include "window/side_docks.h"

class QMainWindow;

namespace vantage {

/// How the docks of the window lie, as it is usual or as the operator left them, and how small it may get.
class WindowLayout final {
 public:
  /// As the docks lie now is usual.
  /// @param guide on the left. @param docks in the order of their keys: four on the right, two at the bottom
  WindowLayout(QMainWindow& window, QDockWidget& guide, const QList<QDockWidget*>& docks);

  /// In the order of their keys.
  [[nodiscard]] const QList<QDockWidget*>& docks() const { return docks_; }

  /// As the operator left it.
  void restore();
  void keep();
  /// As it is usual.
  void reset();
  /// To be called whenever the window is shown: only then its width can be shared out, and its frame is known.
  void shown();
  /// What the window needs without the docks on the right depends on the font.
  void setLeastSize();

 private:
  void layOut();

  QMainWindow& window_;
  QDockWidget& guide_;
  QList<QDockWidget*> docks_;
  SideDocks* sides_;
  QByteArray usual_;
  bool isLaidOut_ = false;   // by the operator, or for the first time
  bool fitsScreen_ = false;  // it is kept inside of its screen when it is shown
};

}  // namespace vantage
