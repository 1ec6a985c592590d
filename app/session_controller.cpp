#include "session_controller.h"

#include <cmath>
#include <utility>

#include "acquisition/apply_command.h"
#include "acquisition/automatic_run.h"
#include "base/errors.h"
#include "io/atomic_file.h"
#include "io/mesh_writer.h"
#include "session/kept_scans.h"
#include "session_start.h"
#include "wording.h"

namespace vantage {
namespace {

const QString kPageNote = QStringLiteral("page");

// Where to go on in a session: where it was left, or, when no window has had it yet, where its state leads.
QString pageOf(const Session& session, const AcquisitionState& state) {
  const std::string noted = session.note(kPageNote.toStdString());
  if (!noted.empty()) return QString::fromStdString(noted);
  if (state.views.empty()) return {};
  return state.termination == Termination::Running ? QStringLiteral("acquire") : QStringLiteral("review");
}

Moment momentOf(const HistoryEntry& entry, bool undone) {
  Moment moment;
  moment.text = commandText(entry.command);
  moment.views = static_cast<int>(entry.outline->views.size());
  moment.undone = undone;
  const auto* added = std::get_if<AddScan>(&entry.command);
  if (added == nullptr) return moment;
  moment.rejected = true;
  for (const OutlinedView& view : entry.outline->views) {
    if (view.scan != added->scan || !view.record) continue;
    moment.rejected = false;
    moment.position = view.record->position;
    moment.newArea = view.record->newArea;
  }
  return moment;
}

}  // namespace

SessionController::SessionController(JobRunner& jobs, std::string cacheFolder, QObject* parent)
    : QObject(parent), jobs_(jobs), cacheFolder_(std::move(cacheFolder)) {}

// What runs refers to this.
SessionController::~SessionController() {
  jobs_.abandonAll();
}

void SessionController::setActivity(Activity activity) {
  if (activity_ == activity) return;
  activity_ = activity;
  emit activityChanged();
}

// Every piece of work goes this way: one at a time, and back to idle whatever came of it.
template <typename T>
void SessionController::start(Activity activity, const QString& title, std::function<T(const Progress&)> process,
                              std::function<void(T)> done) {
  if (!idle()) return;
  setActivity(activity);
  job_ = jobs_.run<T>(title, std::move(process), [this, title, done = std::move(done)](JobResult<T> result) {
    setActivity(Activity::Idle);
    if (result.value)
      done(std::move(*result.value));
    else if (result.cancelled)
      emit message(tr("%1: stopped").arg(title));
    else
      emit failed(result.error);
  });
}

void SessionController::setChoice(const SetUpChoice& choice) {
  if (hasSession() || choice == choice_) return;
  choice_ = choice;
  setUp_.reset();
  testTurn_.reset();
  emit setUpChanged();
}

void SessionController::prepare() {
  if (setUp_ || choice_.scanner.empty()) return;
  start<SharedSetUp>(
      Activity::Preparing, tr("Preparing the set-up"),
      [choice = choice_, cache = cacheFolder_](const Progress& p) { return prepareSetUp(choice, cache, p); },
      [this](SharedSetUp setUp) {
        setUp_ = std::move(setUp);
        if (!setUp_->notes.empty()) emit message(QString::fromStdString(setUp_->notes));
        emit setUpChanged();
      });
}

void SessionController::startTestTurn() {
  if (!setUp_ || !setUp_->profile) return;
  const int first = setUp_->choice.settings.firstView;
  const auto positions = static_cast<int>(setUp_->profile->workspace.size());
  // A twelfth of a turn: far enough to measure, near enough to overlap.
  const int second = (first + std::max(1, setUp_->profile->workspace.steps / 12)) % std::max(1, positions);
  start<TestTurn>(
      Activity::Testing, tr("Test turn"),
      [setUp = setUp_, first, second](const Progress& p) {
        return testTurn(*scannerOf(*setUp, 0), *setUp->profile, first, second, p);
      },
      [this](TestTurn result) {
        testTurn_ = std::move(result);
        emit testTurnChanged();
      });
}

QString SessionController::sessionPath() const {
  return session_ ? QString::fromStdString(session_->path()) : QString();
}

void SessionController::adopt(const SessionPointer& session, const SharedSetUp& setUp, const QString& page) {
  session_ = session;
  setUp_ = setUp;
  choice_ = setUp->choice;
  page_ = page;
  for (const std::string& loss : session->losses()) emit failed(QString::fromStdString(loss));
  emit setUpChanged();
  emit sessionChanged();
}

void SessionController::open(const QString& path) {
  struct Opened {
    OpenedSession opened;
    Publication publication;
  };
  start<Opened>(
      Activity::Opening, tr("Opening the session"),
      [path = path.toStdString(), cache = cacheFolder_](const Progress& p) {
        Opened result{openSession(path, cache, p), {}};
        result.publication = describe(*result.opened.session);
        return result;
      },
      [this](Opened result) {
        adopt(result.opened.session, result.opened.setUp, pageOf(*result.opened.session, *result.publication.state));
        publish(std::move(result.publication));
      });
}

void SessionController::close() {
  if (!idle()) return;
  session_.reset();
  now_.reset();
  shown_.reset();
  shownMoment_ = -1;
  moments_.clear();
  cursor_ = 0;
  page_.clear();
  emit sessionChanged();
  emit stateChanged();
  emit shownChanged();
}

SessionController::Publication SessionController::describe(const Session& session) {
  Publication publication{session.state(), {}, static_cast<int>(session.history().cursor())};
  for (std::size_t i = 0; i < session.history().size(); ++i)
    publication.moments.push_back(momentOf(session.history().entry(i), i > session.history().cursor()));
  return publication;
}

void SessionController::publish(Publication publication) {
  now_ = std::move(publication.state);
  moments_ = std::move(publication.moments);
  cursor_ = publication.cursor;
  shown_.reset();
  shownMoment_ = -1;
  emit stateChanged();
  emit shownChanged();
}

// What a run is told of every step: it is written first, then shown.
std::function<void(const Command&, const AcquisitionState&)> SessionController::recorder(
    const SessionPointer& session) {
  return [this, session, pause = pause_](const Command& command, const AcquisitionState& state) {
    session->record(command, state);
    QMetaObject::invokeMethod(this,
                              [this, publication = describe(*session)]() mutable { publish(std::move(publication)); });
    if (pause && *pause && state.termination == Termination::Running) throw Cancelled();
  };
}

void SessionController::scanInBackground(bool untilTheEnd, std::optional<int> position) {
  if (!setUp_ || !idle()) return;
  pause_ = std::make_shared<std::atomic<bool>>(false);
  const auto begun = [this, setUp = setUp_](const SessionPointer& session) {
    QMetaObject::invokeMethod(this, [this, session, setUp, publication = describe(*session)]() mutable {
      adopt(session, setUp, {});
      publish(std::move(publication));
    });
  };
  start<bool>(
      Activity::Running, untilTheEnd ? tr("Acquiring") : tr("Scanning"),
      [this, session = session_, setUp = setUp_, begun, untilTheEnd, position](const Progress& progress) mutable {
        if (!session) begun(session = createSession(*setUp));
        const auto scanner = scannerOf(*setUp, session->scanCount());
        const ScanSource scans = keptScans(*scanner, *session);
        const auto record = recorder(session);
        AcquisitionState state = *session->state();
        if (position) {
          const ChoosePosition chosen{*position};
          state = applyCommand(state, chosen, {}, {});
          record(chosen, state);
        }
        if (untilTheEnd)
          return acquire(state, scans, *setUp->images, record, progress).termination != Termination::Running;
        const ScanStep step = scanOnce(state, scans, *setUp->images, progress);
        record(step.command, step.state);
        return step.state.termination != Termination::Running;
      },
      [this](bool ended) {
        if (ended) emit runEnded();
      });
}

void SessionController::run() {
  scanInBackground(true, {});
}

void SessionController::step() {
  scanInBackground(false, {});
}

void SessionController::scanFrom(int position) {
  scanInBackground(false, position);
}

void SessionController::pause() {
  if (activity_ != Activity::Running || !pause_) return;
  *pause_ = true;
  setActivity(Activity::Pausing);
}

void SessionController::stop() {
  if (idle()) return;
  jobs_.cancel(job_);
  setActivity(Activity::Stopping);
}

// A command that needs no scan: carried out, written, shown.
void SessionController::change(const Command& command) {
  if (!session_) return;
  start<Publication>(
      Activity::Changing, tr("Changing the session"),
      [session = session_, setUp = setUp_, command](const Progress& progress) {
        const CommandInput input{[session](std::int64_t number) { return session->scan(number); }, setUp->images.get()};
        session->record(command, applyCommand(*session->state(), command, input, progress));
        return describe(*session);
      },
      [this](Publication publication) { publish(std::move(publication)); });
}

void SessionController::choosePosition(int position) {
  change(ChoosePosition{position});
}

void SessionController::endHere() {
  change(Finish{Termination::Finished});
}

void SessionController::goOn() {
  change(Finish{Termination::Running});
}

void SessionController::leaveOut(std::int64_t scan) {
  change(LeaveOutView{scan});
}

void SessionController::takeBack(std::int64_t scan) {
  change(TakeBackView{scan});
}

NextScan SessionController::next() const {
  if (now_) return nextScan(*now_);
  NextScan first;
  first.position = choice_.settings.firstView;
  return first;
}

std::optional<TurnAdvice> SessionController::turnTo(int position) const {
  if (!setUp_ || !setUp_->profile) return {};
  const Workspace& workspace = setUp_->profile->workspace;
  if (workspace.steps == 0 || position < 0 || position >= static_cast<int>(workspace.size())) return {};
  const bool scanned = now_ && !now_->views.empty();
  const int last = scanned ? now_->views.back().image->position : 0;
  if (last < 0) return {};
  const RayGrid& rays = *setUp_->profile->rays;
  const auto azimuth = [&](int i) {
    const Vec3 stand = workspace.poses[static_cast<std::size_t>(i)] * rays.ray(rays.size() / 2).origin;
    return std::atan2(stand.y(), stand.x());
  };
  return TurnAdvice{azimuth(last), azimuth(position), turnBetween(workspace, last, position)};
}

std::optional<Explanation> SessionController::explained(int position) const {
  const auto plan = now_ ? currentPlan(*now_) : nullptr;
  if (!plan || position < 0 || position >= static_cast<int>(plan->scores.size())) return {};
  return explain(*plan, position);
}

void SessionController::move(bool backward) {
  if (!session_) return;
  start<Publication>(
      Activity::Changing, backward ? tr("Undo") : tr("Redo"),
      [session = session_, backward](const Progress& /*progress*/) {
        if (backward)
          session->undo();
        else
          session->redo();
        return describe(*session);
      },
      [this](Publication publication) { publish(std::move(publication)); });
}

void SessionController::undo() {
  if (canUndo()) move(true);
}

void SessionController::redo() {
  if (canRedo()) move(false);
}

void SessionController::showMoment(int index) {
  if (!session_ || index < 0 || index >= static_cast<int>(moments_.size())) return;
  if (index == cursor_) return showNow();
  jobs_.run<SharedState>(
      tr("Showing an earlier moment"),
      [session = session_, index](const Progress&) { return session->state(static_cast<std::size_t>(index)); },
      [this, index](JobResult<SharedState> result) {
        if (!result.value) return;
        shown_ = std::move(*result.value);
        shownMoment_ = index;
        emit shownChanged();
      });
}

void SessionController::showNow() {
  shown_.reset();
  shownMoment_ = -1;
  emit shownChanged();
}

void SessionController::exportModel(const QString& path) {
  if (!now_ || !now_->model) return;
  start<bool>(
      Activity::Writing, tr("Writing %1").arg(path),
      [model = now_->model, path = path.toStdString()](const Progress& progress) {
        vantage::exportModel(*model, path, progress);
        return true;
      },
      [this, path](bool) { emit written(path); });
}

void SessionController::writeReport(const QString& path, ReportParts parts) {
  if (!now_) return;
  start<bool>(
      Activity::Writing, tr("Writing %1").arg(path),
      [state = now_, path = path.toStdString(), parts = std::move(parts)](const Progress& progress) {
        progress.checkpoint(0.0);
        AtomicFile file(path);
        file.write(makeHtmlReport(*state, parts(*state)));
        file.commit();
        return true;
      },
      [this, path](bool) { emit written(path); });
}

void SessionController::rememberPage(const QString& page) {
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
