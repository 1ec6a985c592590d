#pragma once

#include <QObject>
#include <QStringList>

#include "session_controller.h"

class QDropEvent;

namespace vantage {

class ChoosePage;
class JobRunner;
class RecentSessions;
struct Dropped;

/// How sessions and recorded scans come into the window: asks for files, takes what is dropped, and says what stands
/// against it.
class SessionDoor final : public QObject {
  Q_OBJECT

 public:
  /// @param window that dialogs belong to
  SessionDoor(SessionController& controller, JobRunner& jobs, ChoosePage& choosePage, QWidget& window);

  /// Asks for a session and opens it.
  void openSession(SessionAccess access = SessionAccess::Write);
  void openSession(const QString& path, SessionAccess access = SessionAccess::Write);
  /// Into the session that is open, where it can have more; else into a new one.
  void importScans(const QStringList& files);
  /// Opens a session of the list of lately; one that is gone can be taken off it.
  void openRecent(const QString& path, RecentSessions& recent);
  /// Looks beside the UI thread at what was dropped, then opens a session, takes scans in, and asks what a mesh is for.
  void take(QDropEvent& event);

 signals:
  void refused(const QString& why);

 private:
  void take(const Dropped& dropped);
  void takeMesh(const QString& path);
  void refuseDrop(const QString& why);
  void offerToLook(const QString& path, const QString& why);

  SessionController& controller_;
  JobRunner& jobs_;
  ChoosePage& choosePage_;
  QWidget& window_;
};

}  // namespace vantage
