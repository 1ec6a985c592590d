#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "job_runner.h"

namespace vantage {

/// What the window is busy with.
enum class Activity { Idle, Preparing, Testing, Opening, Running, Pausing, Stopping, Changing, Writing };

/// The one piece of work that is under way for the operator: it is begun, asked to pause or stopped, and tells what
/// came of it. While it lasts no other begins. Lives on the UI thread; every call returns at once.
class Undertaking final : public QObject {
  Q_OBJECT

 public:
  explicit Undertaking(JobRunner& jobs, QObject* parent = nullptr);

  [[nodiscard]] Activity activity() const { return activity_; }
  [[nodiscard]] bool idle() const { return activity_ == Activity::Idle; }

  /// Begins work beside the window, unless something is under way. Whatever comes of it, nothing is under way any more
  /// when one of the two is called.
  /// @param title what it is called in the operator's language
  /// @param failed gets why it failed; empty: that is told by the signal
  template <typename T>
  void begin(Activity activity, const QString& title, std::function<T(const Progress&)> process,
             std::function<void(T)> done, std::function<void(const QString&)> failed = {}) {
    if (!idle()) return;
    *pause_ = false;
    scanFailure_.clear();
    step_.clear();
    set(activity);
    job_ = jobs_.run<T>(
        title, std::move(process),
        [this, activity, title, done = std::move(done), onFailure = std::move(failed)](JobResult<T> result) mutable {
          if (activity == Activity::Running) scanFailure_ = result.error;
          set(Activity::Idle);
          if (result.value)
            done(std::move(*result.value));
          else if (result.cancelled)
            emit message(tr("%1: stopped").arg(title));
          else if (onFailure)
            onFailure(result.error);
          else
            emit this->failed(result.error);
        });
  }

  /// The step that it says it is at, as it calls it; empty before it said so.
  [[nodiscard]] const QString& step() const { return step_; }

  /// Asks a run to end after the step that is under way.
  void pause();
  /// Whether what is under way is to pause: for the work itself, on any thread.
  [[nodiscard]] std::shared_ptr<const std::atomic<bool>> pauseWanted() const { return pause_; }
  /// Ends whatever is under way at once.
  void stop();

  /// What ended the last scan or run, as a sentence; empty when nothing failed, or something else was begun since.
  [[nodiscard]] const QString& scanFailure() const { return scanFailure_; }
  void forgetFailure() { scanFailure_.clear(); }

 signals:
  void activityChanged();
  void stepChanged();
  void failed(const QString& what);   ///< one sentence for the operator
  void refused(const QString& why);   ///< what was asked for cannot be done now
  void message(const QString& what);  ///< for the log

 private:
  void set(Activity activity);

  JobRunner& jobs_;
  Activity activity_ = Activity::Idle;
  JobRunner::Id job_ = 0;
  const std::shared_ptr<std::atomic<bool>> pause_ = std::make_shared<std::atomic<bool>>(false);
  QString step_;
  QString scanFailure_;
};

}  // namespace vantage
