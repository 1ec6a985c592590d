#include "stand_desk.h"

#include <utility>

#include "acquisition/stand_composites.h"
#include "acquisition/stand_course.h"
#include "geometry/measures.h"
#include "stand_text.h"

namespace vantage {
namespace {

std::shared_ptr<const StandProspect> computeProspect(const AcquisitionState& state, const Progress& progress) {
  auto prospect = std::make_shared<StandProspect>();
  const AcquisitionState object = withObject(state);
  prospect->outlook = lookAtStands(state, progress.part(0.0, 0.7));
  prospect->leastGain = leastGain(state);
  prospect->profile = object.profile;
  if (!object.model) return prospect;
  prospect->known = area(object.model->mesh);
  prospect->geometry = withPicking(prepareSurface(object.model), progress.part(0.7, 1.0));
  return prospect;
}

}  // namespace

bool StandProspect::worthAnother() const {
  return !outlook.sides.empty() && outlook.sides.front().isNew && outlook.sides.front().gain > leastGain;
}

StandDesk::StandDesk(SessionController& controller, JobRunner& jobs, QObject* parent)
    : QObject(parent), controller_(controller), jobs_(jobs) {
  connect(&controller, &SessionController::stateChanged, this, &StandDesk::refresh);
  connect(&controller, &SessionController::standTried, this,
          [this](int stand, const std::shared_ptr<const StandAlignment>& alignment) {
            if (stand != this->stand()) return;
            tried_ = alignment;
            emit sentenceChanged();
          });
}

// What was found out of another state holds no longer.
void StandDesk::refresh() {
  const SharedState& now = controller_.now();
  if (now != state_) forget();
  const auto recorded = now ? now->stands.back().alignment : nullptr;
  if (recorded != recorded_ || stand() != standBefore_) tried_.reset();
  recorded_ = recorded;
  const bool further = stand() > standBefore_;
  standBefore_ = stand();
  emit sentenceChanged();
  if (std::exchange(turning_, false) && further) emit turned();
}

void StandDesk::forget() {
  stopLooking();
  state_.reset();
  failure_.clear();
  if (std::exchange(prospect_, nullptr)) emit prospectChanged();
}

void StandDesk::look() {
  const SharedState& now = controller_.now();
  if (looking() || prospect_ || !controller_.idle() || !now) return;
  state_ = now;
  failure_.clear();
  ++question_;
  looking_ = true;
  emit prospectChanged();
  const JobRunner::Id job = jobs_.run<std::shared_ptr<const StandProspect>>(
      tr("Looking for sides to put the object on"),
      [state = now](const Progress& progress) { return computeProspect(*state, progress); },
      [this, question = question_](JobResult<std::shared_ptr<const StandProspect>> result) {
        if (question == question_) finish(std::move(result));
      });
  // A runner that works at once has the answer before it gives the number.
  if (looking_) job_ = job;
}

void StandDesk::finish(JobResult<std::shared_ptr<const StandProspect>> result) {
  looking_ = false;
  job_ = 0;
  if (result.value) prospect_ = std::move(*result.value);
  failure_ = result.cancelled ? tr("It was stopped.") : result.error;
  emit prospectChanged();
}

void StandDesk::stopLooking() {
  if (!looking()) return;
  ++question_;
  looking_ = false;
  jobs_.cancel(std::exchange(job_, 0));
}

QString StandDesk::whyNotTurn() const {
  if (QString why = controller_.permissions().whyNot(TurnObject{}); !why.isEmpty()) return why;
  return controller_.permissions().whyNoDevices();
}

void StandDesk::turnOnto(const Vec3& down) {
  if (!whyNotTurn().isEmpty()) return;
  turning_ = true;
  controller_.change(TurnObject{{}, down});
}

int StandDesk::stand() const {
  return controller_.now() ? controller_.now()->stand() : 0;
}

bool StandDesk::isOpen() const {
  return controller_.now() && !isOfObject(*controller_.now(), stand());
}

QString StandDesk::sentence() const {
  const SharedState& now = controller_.now();
  if (!now || stand() == 0) return {};
  if (isOpen() && tried_) return trialSentence(stand(), *tried_);
  QString text = standSentence(now->stands, stand());
  if (isOpen() && !recorded_) text += QLatin1Char(' ') + tr("From its third view on that is tried after every scan.");
  return text;
}

QString StandDesk::whyNotAlign() const {
  return controller_.permissions().whyNot(AlignStand{stand()});
}

void StandDesk::align() {
  controller_.change(AlignStand{stand()});
}

std::optional<int> StandDesk::momentBefore() const {
  const std::vector<Moment>& moments = controller_.present().moments();
  for (int i = controller_.present().cursor(); i > 0; --i)
    if (moments[static_cast<std::size_t>(i) - 1].stand < stand()) return i - 1;
  return std::nullopt;
}

QString StandDesk::whyNotGoBack() const {
  if (!momentBefore()) return tr("The object stands as it did at first.");
  return controller_.permissions().whyNotUndo();
}

void StandDesk::goBack() {
  if (const auto moment = momentBefore()) controller_.goBackTo(*moment);
}

}  // namespace vantage
