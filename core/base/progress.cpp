#include "base/progress.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"

namespace vantage {

Progress::Progress(Report report, std::stop_token stop, int threads)
    : report_(report ? std::make_shared<const Report>(std::move(report)) : nullptr),
      stop_(std::move(stop)),
      threads_(std::max(1, threads)) {}

Progress Progress::part(double from, double to, std::string_view step) const {
  Progress child = *this;
  child.from_ = from_ + (to_ - from_) * from;
  child.to_ = from_ + (to_ - from_) * to;
  if (!step.empty()) child.step_ = step;
  return child;
}

Progress Progress::withThreads(int threads) const {
  Progress copy = *this;
  copy.threads_ = std::max(1, threads);
  return copy;
}

Progress Progress::observedBy(Report observer) const {
  Progress copy = *this;
  copy.report_ = std::make_shared<const Report>(
      [observer = std::move(observer), own = report_](double fraction, std::string_view step) {
        observer(fraction, step);
        if (own) (*own)(fraction, step);
      });
  return copy;
}

void Progress::checkpoint(double fraction) const {
  if (stop_.stop_requested()) throw Cancelled();
  if (report_) (*report_)(from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0), step_);
}

}  // namespace vantage
