#include "session_keeper.h"

#include <utility>

#include "report/loss_wording.h"
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

void SessionKeeper::open(const QString& path) {
  read(
      tr("Opening the session"),
      [path = path.toStdString(), cache = cacheFolder_](const Progress& progress) {
        return openSession(path, cache, progress);
      },
      false);
}

void SessionKeeper::importScans(const ImportChoice& choice) {
  read(
      tr("Importing recorded scans"),
      [choice, cache = cacheFolder_](const Progress& progress) { return importSession(choice, cache, progress); },
      true);
}

void SessionKeeper::read(const QString& title, std::function<OpenedSession(const Progress&)> process, bool imported) {
  std::function<void(const QString&)> notImported;
  if (imported) notImported = [this](const QString& why) { emit importFailed(why); };
  work_.begin<Arrival>(
      Activity::Opening, title,
      [process = std::move(process)](const Progress& progress) {
        Arrival arrival{process(progress), {}};
        arrival.present = Present::of(*arrival.opened.session);
        return arrival;
      },
      [this, imported](const Arrival& arrival) {
        const QString page = pageOf(*arrival.opened.session, *arrival.present.state());
        emit arrived(arrival.opened, arrival.present, page, imported);
      },
      notImported);
}

void SessionKeeper::adopt(const SessionPointer& session, const QString& page) {
  session_ = session;
  page_ = page;
  for (const Loss& loss : session->losses()) emit failed(translated(phraseOf(loss, session->path())));
}

void SessionKeeper::letGo() {
  session_.reset();
  page_.clear();
}

void SessionKeeper::rememberPage(const QString& page) {
  if (page == page_) return;
  page_ = page;
  if (!session_) return;
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
