#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <optional>

#include "recent/session_digest.h"
#include "session_controller.h"

namespace vantage {

/// A session that was open lately.
struct RecentSession {
  QString path;                         ///< absolute
  bool gone = false;                    ///< there is no such file any more
  bool open = false;                    ///< it is the one in the window
  std::optional<SessionDigest> digest;  ///< once it was read; of the open one as it was before
  QString unreadable;                   ///< why it cannot be read; empty when it can, or was not tried
};

/// The sessions that were open lately, the last one first: kept in the settings of the user, read beside the UI thread
/// while nothing is under way. A session leaves the list only when it is taken off, or is the oldest of too many;
/// its file stays in any case.
class RecentSessions final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMost = 8;

  /// @param cacheFolder where pictures of them are kept; empty for nowhere
  RecentSessions(SessionController& controller, JobRunner& jobs, std::string cacheFolder, QObject* parent = nullptr);
  ~RecentSessions() override;

  [[nodiscard]] const QList<RecentSession>& sessions() const { return sessions_; }
  /// Takes a session off the list; its file stays.
  void remove(const QString& path);
  /// Looks again which are there, and reads those that changed.
  void refresh();

 signals:
  void changed();

 private:
  void remember();
  void store(const QStringList& paths);
  void list(const QStringList& paths);
  void readNext();

  SessionController& controller_;
  JobRunner& jobs_;
  std::string cacheFolder_;
  QList<RecentSession> sessions_;
  QStringList toRead_;
  JobRunner::Id job_ = 0;
};

/// What a list says below the name of a session: how far it is and when it was changed last, or that it is gone.
[[nodiscard]] QString recentText(const RecentSession& session);

}  // namespace vantage
