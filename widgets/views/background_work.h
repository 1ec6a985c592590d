#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <thread>

#include "base/progress.h"

namespace vantage {

/// Runs work for a view beside the UI thread. New work replaces what runs: that is asked to stop, and what it still
/// delivers is dropped. Used from the UI thread.
class BackgroundWork {
 public:
  /// Hands something to do to the UI thread.
  using Deliver = std::function<void(std::function<void()>)>;
  using Work = std::function<void(const Progress&, const Deliver&)>;
  using Failed = std::function<void(const QString& why)>;

  BackgroundWork() = default;
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// @param failed called on the UI thread when the work throws, but not when it was cancelled.
  void start(Work work, Failed failed);
  void cancel();
  /// Waits for what runs and does what it delivered.
  void finish();

 private:
  struct Run {
    std::shared_ptr<bool> wanted = std::make_shared<bool>(true);  // of the UI thread
    std::shared_ptr<std::atomic<bool>> done = std::make_shared<std::atomic<bool>>(false);
    std::jthread thread;
  };

  QObject receiver_;
  std::list<Run> runs_;  // the last is the one that is wanted
};

}  // namespace vantage
