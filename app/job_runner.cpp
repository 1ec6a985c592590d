#include "job_runner.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QTimer>
#include <algorithm>
#include <map>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr int kReportInterval = 50;  // [ms]
constexpr int kMaxThreads = 256;
// Threads that a job starts inherit this, so that the window stays quick when every processor is busy.
constexpr int kJobNiceness = 15;

}  // namespace

int machineThreads() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
}

void JobRunner::explain(const std::exception_ptr& failure, bool& cancelled, QString& error) {
  try {
    std::rethrow_exception(failure);
  } catch (const Cancelled&) {
    cancelled = true;
  } catch (const std::bad_alloc&) {
    error = tr("There is not enough memory for this.");
  } catch (const std::exception& e) {
    error = QString::fromUtf8(e.what());
  }
}

struct ThreadedJobRunner::Running {
  Job job;
  std::stop_source stop;
  std::mutex mutex;
  double fraction = 0.0;  // these three under the mutex
  std::string step;
  bool news = false;
  std::exception_ptr failure;
  std::jthread thread;  // last: joined before what it uses goes

  void note(double newFraction, std::string_view newStep) {
    const std::lock_guard lock(mutex);
    // Reports of several threads may overtake each other: a bar never runs backwards within a step.
    fraction = newStep == step ? std::max(fraction, newFraction) : newFraction;
    step = newStep;
    news = true;
  }
};

struct ThreadedJobRunner::Private {
  int threads = 1;
  Id next = 1;
  QTimer timer;
  std::map<Id, std::unique_ptr<Running>> running;
  // Threads that have done their work and are about to end. On a busy machine that takes a while, which is not for the
  // window to wait for: the next job does.
  std::vector<std::jthread> ending;
};

ThreadedJobRunner::ThreadedJobRunner(int threads, QObject* parent)
    : JobRunner(parent), private_(std::make_unique<Private>()) {
  private_->threads = threads;
  private_->timer.setInterval(kReportInterval);
  connect(&private_->timer, &QTimer::timeout, this, &ThreadedJobRunner::report);
}

ThreadedJobRunner::~ThreadedJobRunner() {
  abandonAll();
}

void ThreadedJobRunner::abandonAll() {
  cancelAll();
  private_->running.clear();
  private_->ending.clear();
}

JobRunner::Id ThreadedJobRunner::start(Job job) {
  const Id id = private_->next++;
  Running& running = *(private_->running[id] = std::make_unique<Running>());
  running.job = std::move(job);
  emit started(id, running.job.title);
  private_->timer.start();
  running.thread = std::jthread(
      [this, id, &running, threads = private_->threads, before = std::exchange(private_->ending, {})]() mutable {
        setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kJobNiceness);
        const Progress progress([&running](double fraction, std::string_view step) { running.note(fraction, step); },
                                running.stop.get_token(), threads);
        try {
          running.job.process(progress);
        } catch (...) {
          running.failure = std::current_exception();
        }
        before.clear();
        QMetaObject::invokeMethod(
            this, [this, id] { finish(id); }, Qt::QueuedConnection);
      });
  return id;
}

void ThreadedJobRunner::cancel(Id job) {
  if (const auto it = private_->running.find(job); it != private_->running.end()) it->second->stop.request_stop();
}

void ThreadedJobRunner::cancelAll() {
  for (auto& [id, running] : private_->running) running->stop.request_stop();
}

bool ThreadedJobRunner::busy() const {
  return !private_->running.empty();
}

void ThreadedJobRunner::report() {
  std::map<Id, std::pair<double, QString>> news;
  for (auto& [id, running] : private_->running) {
    const std::lock_guard lock(running->mutex);
    if (std::exchange(running->news, false)) news[id] = {running->fraction, QString::fromStdString(running->step)};
  }
  for (const auto& [id, what] : news) emit progressed(id, what.first, what.second);
}

void ThreadedJobRunner::finish(Id job) {
  const auto it = private_->running.find(job);
  if (it == private_->running.end()) return;
  const std::unique_ptr<Running> over = std::move(it->second);
  private_->running.erase(it);
  private_->ending.push_back(std::move(over->thread));
  if (private_->running.empty()) private_->timer.stop();
  emit finished(job);
  over->job.finalize(over->failure);
}

void SynchronousJobRunner::cancel(Id job) {
  if (running_ > 0 && job == current_) stop_.request_stop();
}

void SynchronousJobRunner::cancelAll() {
  stop_.request_stop();
}

JobRunner::Id SynchronousJobRunner::start(Job job) {
  const Id id = next_++;
  const std::stop_source outer = std::exchange(stop_, std::stop_source());
  const Id outerJob = std::exchange(current_, id);
  ++running_;
  emit started(id, job.title);
  std::exception_ptr failure;
  try {
    job.process(Progress(
        [this, id](double fraction, std::string_view step) {
          emit progressed(id, fraction, QString::fromUtf8(step.data(), static_cast<qsizetype>(step.size())));
        },
        stop_.get_token(), 1));
  } catch (...) {
    failure = std::current_exception();
  }
  stop_ = outer;
  current_ = outerJob;
  --running_;
  emit finished(id);
  job.finalize(failure);
  return id;
}

}  // namespace vantage
