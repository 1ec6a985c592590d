#include "session_controller.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "devices/standing_object.h"
#include "report/memory_note.h"
#include "session/table_note.h"
#include "session_start.h"
#include "wording.h"

namespace vantage {
namespace {

// The set-up with a simulated object that was turned over as the session says.
SharedSetUp asItStands(const SharedSetUp& setUp, const AcquisitionState& state) {
  if (state.stand() == 0 || !std::holds_alternative<Simulated>(*setUp->devices)) return setUp;
  auto turned = std::make_shared<SetUp>(*setUp);
  turned->devices = withObjectAsItStands(*setUp->devices, state);
  return turned;
}

}  // namespace

SessionController::SessionController(JobRunner& jobs, std::string cacheFolder, DeviceFactory devices, QObject* parent)
    : QObject(parent),
      jobs_(jobs),
      cacheFolder_(std::move(cacheFolder)),
      devices_(std::make_shared<RigKeeper>(std::move(devices))),
      work_(jobs),
      bench_(work_, jobs, devices_),
      testScans_(work_, jobs, devices_),
      calibrating_(work_, devices_),
      keeper_(work_, jobs, cacheFolder_),
      writer_(work_),
      present_(presentBefore()) {
  connect(&work_, &Undertaking::activityChanged, this, &SessionController::activityChanged);
  connect(&work_, &Undertaking::stepChanged, this, &SessionController::stepChanged);
  connect(&work_, &Undertaking::failed, this, &SessionController::failed);
  connect(&work_, &Undertaking::refused, this, &SessionController::refused);
  connect(&work_, &Undertaking::message, this, &SessionController::message);
  connect(&keeper_, &SessionKeeper::inUse, this, &SessionController::inUse);
  connect(&keeper_, &SessionKeeper::damaged, this, &SessionController::damaged);
  connect(&keeper_, &SessionKeeper::message, this, &SessionController::message);
  connect(&keeper_, &SessionKeeper::importFailed, this, &SessionController::importFailed);
  connect(&keeper_, &SessionKeeper::arrived, this, &SessionController::replace);
  connect(&writer_, &ResultWriter::written, this, &SessionController::written);
  connect(&writer_, &ResultWriter::madeReady, this, &SessionController::madeReady);
  connect(&writer_, &ResultWriter::printRefused, this, &SessionController::printRefused);
  connect(&calibrating_, &TableCalibrating::kept, this, &SessionController::useCalibration);
}

// What runs refers to this.
SessionController::~SessionController() {
  jobs_.abandonAll();
}

// All who look at the set-up are told.
void SessionController::changeSetUp(const SharedSetUp& setUp) {
  setUp_ = setUp;
  setUpFailure_.clear();
  if (!hasSession()) present_ = presentBefore();
  bench_.setSetUp(setUp);
  testScans_.setSetUp(setUp);
  calibrating_.setSetUp(setUp);
  emit setUpChanged();
}

void SessionController::setChoice(const SetUpChoice& choice) {
  if (hasSession() || choice == choice_) return;
  choice_ = choice;
  memoryNote_.clear();
  changeSetUp({});
}

void SessionController::testTurn() {
  if (allowed(permissions().whyNotTestTurn())) testScans_.turn();
}

void SessionController::testScan() {
  if (allowed(permissions().whyNotTestScan())) testScans_.scan();
}

// The same devices and scanner, from which something else is cut.
void SessionController::setCut(const CutOptions& cut) {
  if (hasSession() || cut == choice_.settings.cut) return;
  choice_.settings.cut = cut;
  if (!setUp_) return;
  auto setUp = std::make_shared<SetUp>(*setUp_);
  setUp->choice.settings.cut = cut;
  changeSetUp(setUp);
}

void SessionController::useCalibration(const QString& path) {
  SetUpChoice calibrated = choice_;
  calibrated.rig.calibration = path.toStdString();
  setChoice(calibrated);
  prepare();
}

void SessionController::prepare() {
  if (setUp_ || choice_.scanner.empty() || !idle()) return;
  setUpFailure_.clear();
  const auto tell = [this, of = choice_](const Phrase& note) {
    QMetaObject::invokeMethod(this, [this, of, note] {
      if (of != choice_) return;
      noteMemory(note);
      emit setUpChanged();
    });
  };
  work_.begin<SharedSetUp>(
      Activity::Preparing, tr("Preparing the set-up"),
      [choice = choice_, cache = cacheFolder_, tell](const Progress& p) {
        if (const auto note = memoryNoteOf(choice)) tell(*note);
        return prepareSetUp(choice, cache, p);
      },
      [this](const SharedSetUp& setUp) {
        if (!hasSession() && turnedByHand(*setUp)) mode_ = Mode::Assisted;
        if (!setUp->notes.empty()) emit message(QString::fromStdString(setUp->notes));
        changeSetUp(setUp);
      },
      [this](const QString& why) {
        setUpFailure_ = why;
        emit setUpChanged();
        emit failed(why);
      });
}

void SessionController::noteMemory(const Phrase& note) {
  const QString text = translated(note);
  memoryNote_ = text.left(1).toUpper() + text.mid(1) + QLatin1Char('.');
  emit message(memoryNote_);
}

void SessionController::adopt(const OpenedSession& opened, const QString& page) {
  const SharedSetUp& setUp = opened.setUp;
  choice_ = setUp->choice;
  memoryNote_.clear();
  if (setUp->profile)
    if (const auto note = vantage::memoryNote(setUp->profile->rays->size(), choice_.settings.thinning,
                                              static_cast<std::size_t>(opened.session->scanCount())))
      noteMemory(*note);
  keeper_.adopt(opened.session, opened.access, page);
  changeSetUp(setUp);
  emit sessionChanged();
}

void SessionController::replace(const OpenedSession& opened, const Present& present, const QString& page,
                                bool isImported) {
  if (hasSession()) close();
  adopt(opened, page);
  publish(present);
  if (isImported) emit imported();
}

void SessionController::open(const QString& path, SessionAccess access) {
  if (allowed(permissions().whyNotOpen())) keeper_.open(path, access);
}

void SessionController::importScans(const ImportChoice& choice) {
  if (allowed(permissions().whyNotOpen())) keeper_.importScans(choice);
}

void SessionController::addScans(const RecordedScans& recorded) {
  if (!allowed(permissions().whyNotAddScans())) return;
  work_.begin<bool>(
      Activity::Changing, tr("Adding scans"),
      [this, session = keeper_.session(), setUp = setUp_, recorded](const Progress& progress) {
        Acquisition acquisition(*session, {{}, setUp->images}, publisher(session));
        addRecordedScans(acquisition, recorded, *setUp, progress);
        return true;
      },
      [this](bool) { emit imported(); }, [this](const QString& why) { emit importFailed(why); });
}

void SessionController::close() {
  if (!allowed(permissions().whyNotClose())) return;
  keeper_.letGo();
  present_ = presentBefore();
  shown_.reset();
  shownMoment_.reset();
  emit sessionChanged();
  emit stateChanged();
  emit shownChanged();
}

void SessionController::publish(Present present) {
  present_ = std::move(present);
  shown_.reset();
  shownMoment_.reset();
  emit stateChanged();
  emit shownChanged();
}

// What was recorded is shown.
Acquisition::StepObserver SessionController::publisher(const SessionPointer& session) {
  return [this, session](const Command&, const AcquisitionState&, const AcquisitionState&) {
    QMetaObject::invokeMethod(this, [this, present = Present::of(*session)]() mutable { publish(std::move(present)); });
  };
}

StandTold SessionController::tellOfStand() {
  return [this](int stand, const std::shared_ptr<const StandAlignment>& alignment) {
    QMetaObject::invokeMethod(this, [this, stand, alignment] { emit standTried(stand, alignment); });
  };
}

void SessionController::scanInBackground(bool untilTheEnd) {
  const auto begun = [this, setUp = setUp_](const SessionPointer& session) {
    QMetaObject::invokeMethod(this, [this, session, setUp, present = Present::of(*session)]() mutable {
      adopt({session, setUp, SessionAccess::Write}, {});
      publish(std::move(present));
    });
  };
  work_.begin<bool>(
      Activity::Running, untilTheEnd ? tr("Acquiring") : tr("Scanning"),
      [this, session = keeper_.session(), setUp = setUp_, devices = devices_, mode = mode(), begun,
       pause = work_.pauseWanted(), untilTheEnd](const Progress& progress) mutable {
        const bool isNew = !session;
        // Without devices there is nothing that a session could be begun with.
        const auto left = isNew ? std::nullopt : tableLeft(*session);
        RigKeeper::Use use =
            devices->open(isNew ? setUp : asItStands(setUp, *session->state()), isNew ? 0 : session->scanCount(),
                          left ? left->stand : TableStand{}, progress);
        if (isNew)
          session = createSession(*setUp);
        else if (std::holds_alternative<RealDevices>(*setUp->devices))
          rememberDevices(*session, *setUp);
        Rig rig = use.rig();
        if (std::holds_alternative<RealDevices>(*setUp->devices)) rig = remarked(rig, *session);
        Acquisition acquisition(*session, {rig, setUp->images, tellingAligner(tellOfStand())}, publisher(session));
        if (isNew) {
          if (mode != acquisition.state()->mode) acquisition.carryOut(ChangeMode{mode});
          begun(session);
        }
        if (acquisition.state()->termination == Termination::EndedByOperator)
          acquisition.carryOut(Finish{Termination::Running});
        try {
          return scanStand(
              acquisition, untilTheEnd, [pause] { return pause->load(); }, progress);
        } catch (const DeviceError&) {
          use.drop();
          throw;
        }
      },
      [this](bool ended) {
        if (ended) emit runEnded();
      });
}

Permissions SessionController::permissions() const {
  return Permissions({.busy = !idle(),
                      .sessionOpen = hasSession(),
                      .mode = mode(),
                      .setUp = setUp_,
                      .now = now(),
                      .somethingBefore = present_.somethingBefore(),
                      .somethingUndone = present_.somethingUndone(),
                      .readOnly = readOnly()});
}

bool SessionController::allowed(const QString& whyNot) {
  if (!whyNot.isEmpty()) emit refused(whyNot);
  return whyNot.isEmpty();
}

void SessionController::setMode(Mode mode) {
  if (mode == this->mode()) return;
  if (hasSession()) return change(ChangeMode{mode});
  mode_ = mode;
  emit stateChanged();
}

void SessionController::run() {
  if (allowed(permissions().whyNotRun())) scanInBackground(true);
}

void SessionController::step() {
  if (allowed(permissions().whyNotScan())) scanInBackground(false);
}

void SessionController::turnByHand() {
  if (!setUp_ || !canTurnByHand() || !idle()) return;
  auto setUp = std::make_shared<SetUp>(*setUp_);
  setUp->choice.rig.table = HandTableDevice{};
  connectDevices(*setUp);
  work_.forgetFailure();
  changeSetUp(setUp);
  setMode(Mode::Assisted);
  emit activityChanged();
}

bool SessionController::canTurnByHand() const {
  return setUp_ && setUp_->devices && std::holds_alternative<RealDevices>(*setUp_->devices) && !turnedByHand(*setUp_);
}

void SessionController::pause() {
  work_.pause();
}

void SessionController::stop() {
  work_.stop();
}

void SessionController::change(const Command& command) {
  if (!allowed(permissions().whyNot(command))) return;
  work_.begin<Present>(
      Activity::Changing, tr("Changing the session"),
      [session = keeper_.session(), setUp = setUp_, command](const Progress& progress) {
        Acquisition(*session, {{}, setUp->images}).carryOut(command, progress);
        return Present::of(*session);
      },
      [this](Present present) { publish(std::move(present)); });
}

void SessionController::choosePosition(std::optional<int> position) {
  change(ChoosePosition{position});
}

void SessionController::endHere() {
  change(Finish{Termination::EndedByOperator});
}

void SessionController::allowMoreViews(int more) {
  ChangeSettings command{now() ? now()->settings : choice_.settings};
  command.settings.maxViews += more;
  change(command);
}

void SessionController::leaveOut(std::int64_t scan) {
  change(LeaveOutView{scan});
}

void SessionController::takeBack(std::int64_t scan) {
  change(TakeBackView{scan});
}

void SessionController::takeAsFrom(std::int64_t scan, double tableDeg) {
  change(TakeAsFrom{scan, tableDeg});
}

Present SessionController::presentBefore() const {
  const bool hasPositions = setUp_ && setUp_->profile && setUp_->profile->workspace.size() > 0;
  return Present::before(choice_.settings.firstView, hasPositions ? std::optional(0) : std::nullopt);
}

std::optional<TurnAdvice> SessionController::turnTo(int position) const {
  if (!setUp_ || !setUp_->profile) return {};
  return adviseTurn(*setUp_->profile, present().tablePosition(), position);
}

void SessionController::moveTo(int moment, const QString& title) {
  work_.begin<Present>(
      Activity::Changing, title,
      [session = keeper_.session(), moment = static_cast<std::size_t>(moment)](const Progress& /*progress*/) {
        Acquisition acquisition(*session);
        while (session->history().cursor() > moment) acquisition.undo();
        while (session->history().cursor() < moment) acquisition.redo();
        return Present::of(*session);
      },
      [this](Present present) { publish(std::move(present)); });
}

void SessionController::undo() {
  if (allowed(permissions().whyNotUndo())) moveTo(present_.cursor() - 1, tr("Undo"));
}

void SessionController::redo() {
  if (allowed(permissions().whyNotRedo())) moveTo(present_.cursor() + 1, tr("Redo"));
}

void SessionController::goBackTo(int moment) {
  if (moment < 0 || moment >= present_.cursor()) return;
  if (allowed(permissions().whyNotUndo())) moveTo(moment, tr("Undo"));
}

void SessionController::showMoment(int index) {
  if (!hasSession() || index < 0 || index >= static_cast<int>(present_.moments().size())) return;
  if (index == present_.cursor()) return showNow();
  jobs_.run<SharedState>(
      tr("Showing an earlier moment"),
      [session = keeper_.session(), index](const Progress&) { return session->state(static_cast<std::size_t>(index)); },
      [this, index](JobResult<SharedState> result) {
        if (!result.value) return;
        shown_ = std::move(*result.value);
        shownMoment_ = index;
        emit shownChanged();
      });
}

void SessionController::showNow() {
  shown_.reset();
  shownMoment_.reset();
  emit shownChanged();
}

std::vector<std::string> SessionController::filesInUse() const {
  return {keeper_.session()->path(), now()->settings.simulation.object, choice_.scanner};
}

void SessionController::exportModel(const QString& path) {
  if (allowed(permissions().whyNotExport())) writer_.exportModel(now(), path, filesInUse());
}

void SessionController::exportFinished(const QString& path, const HandOver& how) {
  if (allowed(permissions().whyNotExport())) writer_.exportFinished(now(), path, how, filesInUse());
}

void SessionController::writeReport(const QString& path, ReportParts parts) {
  if (allowed(permissions().whyNotExport())) writer_.writeReport(now(), path, std::move(parts), filesInUse());
}

}  // namespace vantage
