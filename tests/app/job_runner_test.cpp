#include "job_runner.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QThread>
#include <atomic>
#include <new>
#include <thread>

#include "base/errors.h"

namespace vantage {
namespace {

// Runs the event loop until the condition holds, for some seconds at most.
template <typename Condition>
bool waitFor(Condition condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < 10000) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  return condition();
}

template <typename T>
std::optional<JobResult<T>> runToTheEnd(JobRunner& runner, std::function<T(const Progress&)> process) {
  std::optional<JobResult<T>> result;
  runner.run<T>("job", std::move(process), [&](JobResult<T> r) { result = std::move(r); });
  EXPECT_TRUE(waitFor([&] { return result.has_value(); }));
  return result;
}

// Both runners keep the same rules.
class AnyJobRunner : public ::testing::TestWithParam<bool> {
 protected:
  AnyJobRunner() {
    if (GetParam())
      runner_ = std::make_unique<ThreadedJobRunner>(2);
    else
      runner_ = std::make_unique<SynchronousJobRunner>();
  }
  std::unique_ptr<JobRunner> runner_;
};
INSTANTIATE_TEST_SUITE_P(Both, AnyJobRunner, ::testing::Values(false, true),
                         [](const auto& p) { return p.param ? "Threaded" : "Synchronous"; });

TEST_P(AnyJobRunner, HandsTheValueToFinalizeOnItsOwnThread) {
  QThread* where = nullptr;
  int value = 0;
  runner_->run<int>(
      "job", [](const Progress&) { return 42; },
      [&](const JobResult<int>& result) {
        where = QThread::currentThread();
        value = result.value.value_or(-1);
      });
  ASSERT_TRUE(waitFor([&] { return where != nullptr; }));
  EXPECT_EQ(where, QThread::currentThread());
  EXPECT_EQ(value, 42);
  EXPECT_FALSE(runner_->busy());
}

TEST_P(AnyJobRunner, TurnsExceptionsIntoASentence) {
  const auto result =
      runToTheEnd<int>(*runner_, [](const Progress&) -> int { throw InvalidInput("mug.ply: has no triangles"); });
  EXPECT_FALSE(result->value);
  EXPECT_FALSE(result->cancelled);
  EXPECT_EQ(result->error, "mug.ply: has no triangles");
  EXPECT_FALSE(runToTheEnd<int>(*runner_, [](const Progress&) -> int { throw std::bad_alloc(); })->error.isEmpty());
}

TEST_P(AnyJobRunner, TellsACancelledJobFromAFailedOne) {
  const auto result = runToTheEnd<int>(*runner_, [](const Progress&) -> int { throw Cancelled(); });
  EXPECT_TRUE(result->cancelled);
  EXPECT_TRUE(result->error.isEmpty());
}

TEST_P(AnyJobRunner, ReportsStartStepAndEndOfEachJob) {
  QSignalSpy started(runner_.get(), &JobRunner::started);
  QSignalSpy finished(runner_.get(), &JobRunner::finished);
  QSignalSpy progressed(runner_.get(), &JobRunner::progressed);
  runToTheEnd<int>(*runner_, [](const Progress& progress) {
    progress.part(0.0, 0.5, "measuring").checkpoint(0.5);
    QThread::msleep(150);
    return 1;
  });
  ASSERT_EQ(started.count(), 1);
  EXPECT_EQ(finished.count(), 1);
  EXPECT_EQ(started[0][1].toString(), "job");
  ASSERT_GE(progressed.count(), 1);
  EXPECT_EQ(progressed[0][1].toDouble(), 0.25);
  EXPECT_EQ(progressed[0][2].toString(), "measuring");
}

// What a thread still does when its work is done.
struct Lingering {
  std::atomic<bool>* goOn = nullptr;
  ~Lingering() {
    while (goOn != nullptr && !*goOn) QThread::msleep(1);
  }
};

TEST(ThreadedJobRunner, DoesNotWaitForTheEndOfAThreadWhoseWorkIsDone) {
  std::atomic<bool> goOn = false;
  ThreadedJobRunner runner(1);
  std::jthread late([&] {
    for (int i = 0; i < 9000 && !goOn; ++i) QThread::msleep(1);
    goOn = true;
  });
  const auto result = runToTheEnd<int>(runner, [&](const Progress&) {
    thread_local Lingering lingering;
    lingering.goOn = &goOn;
    return 1;
  });
  EXPECT_EQ(result->value, 1);
  EXPECT_FALSE(runner.busy());
  EXPECT_FALSE(goOn);
  goOn = true;
  EXPECT_EQ(runToTheEnd<int>(runner, [](const Progress&) { return 2; })->value, 2);
}

TEST(ThreadedJobRunner, CancelIsAnsweredAtTheNextCheckpoint) {
  ThreadedJobRunner runner(1);
  std::atomic<bool> running = false;
  bool cancelled = false;
  const int job = runner.run<int>(
      "job",
      [&](const Progress& progress) {
        for (running = true;; QThread::msleep(1)) progress.checkpoint(0.0);
        return 1;
      },
      [&](const JobResult<int>& result) { cancelled = result.cancelled; });
  ASSERT_TRUE(waitFor([&] { return running.load(); }));
  runner.cancel(job);
  EXPECT_TRUE(waitFor([&] { return cancelled; }));
}

TEST(ThreadedJobRunner, CancellingOneJobLeavesTheOthersAlone) {
  ThreadedJobRunner runner(1);
  std::atomic<bool> go = false;
  std::optional<int> value;
  bool cancelled = false;
  const auto waiting = [&](const Progress& progress) {
    while (!go) progress.checkpoint(0.0);
    return 7;
  };
  const int first = runner.run<int>("a", waiting, [&](const JobResult<int>& r) { cancelled = r.cancelled; });
  runner.run<int>("b", waiting, [&](const JobResult<int>& r) { value = r.value; });
  runner.cancel(first);
  ASSERT_TRUE(waitFor([&] { return cancelled; }));
  EXPECT_TRUE(runner.busy());
  go = true;
  EXPECT_TRUE(waitFor([&] { return value == 7; }));
}

TEST(ThreadedJobRunner, ABarNeverRunsBackwardsWithinAStep) {
  ThreadedJobRunner runner(1);
  QSignalSpy progressed(&runner, &JobRunner::progressed);
  runToTheEnd<int>(runner, [](const Progress& progress) {
    const Progress step = progress.part(0.0, 1.0, "step");
    for (const double fraction : {0.5, 0.2, 0.8, 0.3}) {
      step.checkpoint(fraction);
      QThread::msleep(70);
    }
    return 1;
  });
  ASSERT_GE(progressed.count(), 2);
  for (int i = 1; i < progressed.count(); ++i) EXPECT_GE(progressed[i][1].toDouble(), progressed[i - 1][1].toDouble());
}

TEST(ThreadedJobRunner, AnAbandonedJobIsNotFinalized) {
  bool finalized = false;
  std::atomic<bool> running = false;
  {
    ThreadedJobRunner runner(1);
    runner.run<int>(
        "job",
        [&](const Progress& progress) {
          for (running = true;;) progress.checkpoint(0.0);
          return 1;
        },
        [&](const JobResult<int>&) { finalized = true; });
    ASSERT_TRUE(waitFor([&] { return running.load(); }));
  }
  QCoreApplication::processEvents();
  EXPECT_FALSE(finalized);
}

}  // namespace
}  // namespace vantage
