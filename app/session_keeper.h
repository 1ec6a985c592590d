#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <string>

#include "job_runner.h"
#include "present.h"
#include "session_import.h"
#include "undertaking.h"

namespace vantage {

/// The session of the window: opens one, makes one of recorded scans, keeps it, and the wizard's page in it. Lives on
/// the UI thread; every call returns at once.
class SessionKeeper final : public QObject {
  Q_OBJECT

 public:
  using SessionPointer = std::shared_ptr<Session>;

  /// @param cacheFolder where images of scanners are kept; empty for nowhere.
  SessionKeeper(Undertaking& work, JobRunner& jobs, std::string cacheFolder, QObject* parent = nullptr);

  /// Nothing where none is open.
  [[nodiscard]] const SessionPointer& session() const { return session_; }
  /// Empty where none is open.
  [[nodiscard]] QString path() const;
  /// Whether it may only be looked at.
  [[nodiscard]] bool readOnly() const { return session_ && access_ == SessionAccess::Read; }

  /// Reads a session whole; the one that is kept stays so until whoever hears `arrived` adopts it.
  void open(const QString& path, SessionAccess access);
  /// Makes a session of recorded scans, likewise. What is wrong with them is told by importFailed.
  void importScans(const ImportChoice& choice);

  /// Keeps a session from now on, and tells what it has lost.
  /// @param page of the wizard that it was left at
  void adopt(const SessionPointer& session, SessionAccess access, const QString& page);
  /// Leaves the session as it is on the disk.
  void letGo();

  /// The wizard's page, kept in the session so that it reopens there.
  [[nodiscard]] const QString& page() const { return page_; }
  void rememberPage(const QString& page);

 signals:
  /// @param imported it was made of recorded scans just now
  void arrived(const OpenedSession& opened, const Present& present, const QString& page, bool imported);
  void importFailed(const QString& why);
  void inUse(const QString& path, const QString& why);  ///< it is not opened: another program writes to it
  void damaged(const QStringList& losses);              ///< what cannot be read of the session that was opened
  void message(const QString& what);                    ///< for the log

 private:
  struct Arrival {
    OpenedSession opened;
    Present present;
    QString heldBy;  ///< empty, or why it is not opened
  };
  void read(const QString& title, const QString& path, std::function<OpenedSession(const Progress&)> process,
            bool imported);

  Undertaking& work_;
  JobRunner& jobs_;
  std::string cacheFolder_;
  SessionPointer session_;
  SessionAccess access_ = SessionAccess::Write;
  QString page_;
};

}  // namespace vantage
