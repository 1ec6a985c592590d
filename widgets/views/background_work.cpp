#include "views/background_work.h"

#include <QCoreApplication>
#include <QEvent>
#include <exception>

#include "base/errors.h"

namespace vantage {

BackgroundWork::~BackgroundWork() {
  cancel();
}

void BackgroundWork::start(Work work, Failed failed) {
  cancel();
  Run& run = runs_.emplace_back();
  const Deliver deliver = [this, wanted = run.wanted](std::function<void()> action) {
    QMetaObject::invokeMethod(
        &receiver_,
        [wanted, action = std::move(action)] {
          if (*wanted) action();
        },
        Qt::QueuedConnection);
  };
  run.thread = std::jthread(
      [work = std::move(work), failed = std::move(failed), deliver, done = run.done](const std::stop_token& stop) {
        try {
          work(Progress({}, stop, 1), deliver);
        } catch (const Cancelled&) {
          // What replaced this work delivers instead.
        } catch (const std::exception& e) {
          deliver([failed, why = QString::fromUtf8(e.what())] { failed(why); });
        }
        *done = true;
      });
}

void BackgroundWork::cancel() {
  // Stopped threads are not waited for: that would hold up the UI. They end with this object at the latest.
  for (Run& run : runs_) {
    run.thread.request_stop();
    *run.wanted = false;
  }
  std::erase_if(runs_, [](const Run& run) { return run.done->load(); });
}

void BackgroundWork::finish() {
  if (!runs_.empty() && runs_.back().thread.joinable()) runs_.back().thread.join();
  QCoreApplication::sendPostedEvents(&receiver_, QEvent::MetaCall);
}

}  // namespace vantage
