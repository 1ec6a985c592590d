#pragma once

#include <QWidget>
#include <functional>

#include "recent/recent_sessions.h"

class QListWidget;
class QMenu;

namespace vantage {

/// The sessions of lately with their pictures, on a page: a click or Enter opens one, Delete takes one off the list. It
/// is hidden while there is none, and while a session is open.
class RecentList final : public QWidget {
  Q_OBJECT

 public:
  RecentList(RecentSessions& sessions, const SessionController& controller, QWidget* parent = nullptr);

 signals:
  void chosen(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void choose();
  void showMenu(const QPoint& place);
  [[nodiscard]] const RecentSession* current() const;

  RecentSessions& sessions_;
  const SessionController& controller_;
  QListWidget* list_;
};

/// The same as a menu, made anew whenever it comes up.
/// @param choose gets the path of the one that is chosen
void fillRecentMenu(QMenu& menu, RecentSessions& sessions, const std::function<void(const QString& path)>& choose);

/// Says that a session is gone, and offers to take it off the list.
void offerToForget(RecentSessions& sessions, const QString& path, QWidget& parent);

}  // namespace vantage
