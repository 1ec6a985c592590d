#include "undertaking.h"

namespace vantage {

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
