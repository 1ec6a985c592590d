#pragma once

#include <QObject>
#include <QStringList>

#include "session_controller.h"

class QDropEvent;

namespace vantage {

class ChoosePage;

/// How sessions and recorded scans come into the window: asks for files, takes what is dropped, and says what stands
/// against it.
class SessionDoor final : public QObject {
  Q_OBJECT

 public:
  /// @param window that dialogs belong to
  SessionDoor(SessionController& controller, const ChoosePage& choosePage, QWidget& window);

  /// Asks for a session and opens it.
  void openSession(SessionAccess access = SessionAccess::Write);
  void openSession(const QString& path, SessionAccess access = SessionAccess::Write);
  /// Into the session that is open, where it can have more; else into a new one.
  void importScans(const QStringList& files);
  /// A session is opened; everything else is taken for scans.
  void take(QDropEvent& event);

 signals:
  void refused(const QString& why);

 private:
  void offerToLook(const QString& path, const QString& why);

  SessionController& controller_;
  const ChoosePage& choosePage_;
  QWidget& window_;
};

}  // namespace vantage
