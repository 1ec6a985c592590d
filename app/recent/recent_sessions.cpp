#include "recent/recent_sessions.h"

#include <QFileInfo>
#include <QLocale>
#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <utility>

namespace vantage {
namespace {

const QString kRecentKey = QStringLiteral("recentSessions");

}  // namespace

RecentSessions::RecentSessions(SessionController& controller, JobRunner& jobs, std::string cacheFolder, QObject* parent)
    : QObject(parent), controller_(controller), jobs_(jobs), cacheFolder_(std::move(cacheFolder)) {
  connect(&controller, &SessionController::sessionChanged, this, &RecentSessions::remember);
  connect(&controller, &SessionController::activityChanged, this, &RecentSessions::readNext);
  refresh();
}

RecentSessions::~RecentSessions() {
  jobs_.cancel(job_);
}

void RecentSessions::remember() {
  QStringList paths = QSettings().value(kRecentKey).toStringList();
  if (controller_.hasSession()) {
    const QString path = QFileInfo(controller_.sessionPath()).absoluteFilePath();
    paths.removeAll(path);
    paths.prepend(path);
    while (paths.size() > kMost) forgetDigest(paths.takeLast(), cacheFolder_);
    store(paths);
  }
  list(paths);
}

void RecentSessions::store(const QStringList& paths) {
  QSettings file;
  file.setValue(kRecentKey, paths);
  file.sync();
}

void RecentSessions::remove(const QString& path) {
  QStringList paths = QSettings().value(kRecentKey).toStringList();
  paths.removeAll(path);
  store(paths);
  forgetDigest(path, cacheFolder_);
  list(paths);
}

void RecentSessions::refresh() {
  list(QSettings().value(kRecentKey).toStringList());
}

void RecentSessions::list(const QStringList& paths) {
  const QString open = controller_.hasSession() ? QFileInfo(controller_.sessionPath()).absoluteFilePath() : QString();
  QList<RecentSession> sessions;
  toRead_.clear();
  for (const QString& path : paths) {
    const auto known =
        std::find_if(sessions_.begin(), sessions_.end(), [&](const RecentSession& s) { return s.path == path; });
    RecentSession session = known != sessions_.end() ? *known : RecentSession{path, false, false, {}, {}};
    session.gone = !QFileInfo(path).isFile();
    session.open = path == open;
    const bool stale = !session.digest || session.digest->changed != changeOf(path);
    if (!session.gone && !session.open && stale) toRead_ << path;
    sessions << session;
  }
  sessions_ = sessions;
  emit changed();
  readNext();
}

// One after the other, and while a run goes on not at all: the processors are its own then.
void RecentSessions::readNext() {
  if (job_ != 0 || toRead_.isEmpty() || !controller_.idle()) return;
  const QString path = toRead_.takeFirst();
  job_ = -1;  // A job may be done when it is begun.
  const JobRunner::Id id = jobs_.run<SessionDigest>(
      {}, [path, cache = cacheFolder_](const Progress& progress) { return digestOf(path, cache, progress); },
      [self = QPointer(this), path](JobResult<SessionDigest> result) {
        if (!self) return;
        self->job_ = 0;
        for (RecentSession& session : self->sessions_) {
          if (session.path != path || result.cancelled) continue;
          session.digest = std::move(result.value);
          session.unreadable = result.error;
          emit self->changed();
          break;
        }
        self->readNext();
      });
  if (job_ == -1) job_ = id;
}

QString recentText(const RecentSession& session) {
  if (session.gone) return RecentSessions::tr("gone: no such file");
  if (session.open) return RecentSessions::tr("open now");
  if (!session.unreadable.isEmpty()) return RecentSessions::tr("cannot be read");
  if (!session.digest) return RecentSessions::tr("not read yet");
  return RecentSessions::tr("%1\n%2").arg(
      progressText(*session.digest),
      RecentSessions::tr("changed %1").arg(QLocale().toString(session.digest->changed, QLocale::ShortFormat)));
}

}  // namespace vantage
