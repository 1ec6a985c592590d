#include "session_keeper.h"

#include <utility>

#include "report/loss_wording.h"
#include "session/session_lock.h"
#include "wording.h"

namespace vantage {
namespace {

const QString kPageNote = QStringLiteral("page");

// Where to go on in a session: where it was left, or, when no window has had it yet, where its state leads.
QString pageOf(const Session& session, const AcquisitionState& state) {
  const std::string noted = session.note(kPageNote.toStdString());
  if (!noted.empty()) return QString::fromStdString(noted);
  if (state.scans.empty()) return {};
  return state.termination == Termination::Running ? QStringLiteral("acquire") : QStringLiteral("review");
}

}  // namespace

SessionKeeper::SessionKeeper(Undertaking& work, JobRunner& jobs, std::string cacheFolder, QObject* parent)
    : QObject(parent), work_(work), jobs_(jobs), cacheFolder_(std::move(cacheFolder)) {}

QString SessionKeeper::path() const {
  return session_ ? QString::fromStdString(session_->path()) : QString();
}

void SessionKeeper::open(const QString& path, SessionAccess access) {
  read(
      tr("Opening the session"), path,
      [path = path.toStdString(), access, cache = cacheFolder_](const Progress& progress) {
        return openSession(path, access, cache, progress);
      },
      false);
}

void SessionKeeper::importScans(const ImportChoice& choice) {
  read(
      tr("Importing recorded scans"), {},
      [choice, cache = cacheFolder_](const Progress& progress) { return importSession(choice, cache, progress); },
      true);
}

void SessionKeeper::read(const QString& title, const QString& path,
                         std::function<OpenedSession(const Progress&)> process, bool imported) {
  std::function<void(const QString&)> notImported;
  if (imported) notImported = [this](const QString& why) { emit importFailed(why); };
  work_.begin<Arrival>(
      Activity::Opening, title,
      [process = std::move(process)](const Progress& progress) {
        try {
          Arrival arrival{process(progress), {}, {}};
          arrival.present = Present::of(*arrival.opened.session);
          return arrival;
        } catch (const SessionInUse& e) {
          return Arrival{{}, {}, QString::fromUtf8(e.what())};
        }
      },
      [this, path, imported](const Arrival& arrival) {
        if (!arrival.heldBy.isEmpty()) {
          emit inUse(path, arrival.heldBy);
          return;
        }
        const QString page = pageOf(*arrival.opened.session, *arrival.present.state());
        emit arrived(arrival.opened, arrival.present, page, imported);
      },
      notImported);
}

void SessionKeeper::adopt(const SessionPointer& session, SessionAccess access, const QString& page) {
  session_ = session;
  access_ = access;
  page_ = page;
  QStringList losses;
  for (const Loss& loss : session->losses()) losses << translated(phraseOf(loss, session->path()));
  if (!losses.isEmpty()) emit damaged(losses);
}

void SessionKeeper::letGo() {
  session_.reset();
  page_.clear();
}

void SessionKeeper::rememberPage(const QString& page) {
  if (page == page_) return;
  page_ = page;
  if (!session_ || readOnly()) return;
  jobs_.run<bool>(
      {},
      [session = session_, page = page.toStdString()](const Progress&) {
        session->setNote(kPageNote.toStdString(), page);
        return true;
      },
      [this](const JobResult<bool>& result) {
        if (!result.error.isEmpty()) emit message(result.error);
      });
}

}  // namespace vantage
