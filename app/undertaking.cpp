#include "undertaking.h"

namespace vantage {

Undertaking::Undertaking(JobRunner& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {
  connect(&jobs, &JobRunner::progressed, this, [this](int job, double /*fraction*/, const QString& step) {
    if (job != job_ || idle() || step == step_) return;
    step_ = step;
    emit stepChanged();
  });
}

void Undertaking::set(Activity activity) {
  if (activity_ == activity) return;
  activity_ = activity;
  emit activityChanged();
}

void Undertaking::pause() {
  if (activity_ != Activity::Running) {
    emit refused(tr("Nothing runs that could pause."));
    return;
  }
  *pause_ = true;
  set(Activity::Pausing);
}

void Undertaking::stop() {
  if (idle()) {
    emit refused(tr("Nothing runs that could be stopped."));
    return;
  }
  jobs_.cancel(job_);
  set(Activity::Stopping);
}

}  // namespace vantage
