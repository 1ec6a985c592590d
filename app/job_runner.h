#pragma once

#include <QObject>
#include <QString>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "base/progress.h"

namespace vantage {

/// What became of a job: its value, or why there is none.
template <typename T>
struct JobResult {
  std::optional<T> value;
  bool cancelled = false;
  QString error;  ///< one sentence for the operator; empty unless the job failed
};

/// Runs work beside the window. A job has two halves: `process` does the work with a Progress, anywhere; `finalize`
/// gets what came of it, on the thread that the runner lives on, also when the work was cancelled or failed. Here, and
/// nowhere else in the window, exceptions of the engine are caught.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  using Id = int;

  using QObject::QObject;

  /// Starts a job. The value of `process` must be movable.
  template <typename T>
  Id run(const QString& title, std::function<T(const Progress&)> process, std::function<void(JobResult<T>)> finalize) {
    auto value = std::make_shared<std::optional<T>>();
    return start({title,
                  [value, process = std::move(process)](const Progress& progress) { *value = process(progress); },
                  [value, finalize = std::move(finalize)](const std::exception_ptr& failure) {
                    JobResult<T> result;
                    if (failure)
                      explain(failure, result.cancelled, result.error);
                    else
                      result.value = std::move(*value);
                    finalize(std::move(result));
                  }});
  }

  /// Asks a job to stop. It is answered by its finalize; a job that is over is left alone.
  virtual void cancel(Id job) = 0;
  virtual void cancelAll() = 0;
  /// Stops all jobs and waits for them; their finalize is not called any more. For who is about to go while they run.
  virtual void abandonAll() = 0;
  [[nodiscard]] virtual bool busy() const = 0;

 signals:
  void started(int job, const QString& title);
  /// Overall fraction 0..1 and the name of the running step; never more than some twenty times a second.
  void progressed(int job, double fraction, const QString& step);
  void finished(int job);

 protected:
  struct Job {
    QString title;
    std::function<void(const Progress&)> process;
    std::function<void(std::exception_ptr)> finalize;
  };
  virtual Id start(Job job) = 0;

 private:
  static void explain(const std::exception_ptr& failure, bool& cancelled, QString& error);
};

/// Every job on a thread of its own, a little less urgent than the window.
class ThreadedJobRunner final : public JobRunner {
  Q_OBJECT

 public:
  /// @param threads that a job may use.
  explicit ThreadedJobRunner(int threads, QObject* parent = nullptr);
  ~ThreadedJobRunner() override;

  void cancel(Id job) override;
  void cancelAll() override;
  void abandonAll() override;
  [[nodiscard]] bool busy() const override;

 protected:
  Id start(Job job) override;

 private:
  struct Running;
  void report();
  void finish(Id job);

  struct Private;
  std::unique_ptr<Private> private_;
};

/// Runs every job to its end inside of start(): for tests.
class SynchronousJobRunner final : public JobRunner {
  Q_OBJECT

 public:
  using JobRunner::JobRunner;

  /// Works for the running job only, so it is its progress that calls.
  void cancel(Id job) override;
  void cancelAll() override;
  void abandonAll() override {}
  [[nodiscard]] bool busy() const override { return running_ > 0; }

 protected:
  Id start(Job job) override;

 private:
  int next_ = 1;
  int running_ = 0;
  Id current_ = 0;  // the job that runs, or the innermost of them
  std::stop_source stop_;
};

/// Threads that work beside the window may use on this machine.
[[nodiscard]] int machineThreads();

}  // namespace vantage
