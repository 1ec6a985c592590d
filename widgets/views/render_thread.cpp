#include "views/render_thread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace vantage {
namespace {

// Less urgent than the window, which must answer, and more than the jobs, which nobody sees.
constexpr int kNiceness = 5;

}  // namespace

RenderThread::RenderThread(bool apart) : apart_(apart) {
  if (!apart_) return;
  place_.moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("render"));
  thread_.start();
  post([] { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness); });
}

RenderThread::~RenderThread() {
  thread_.quit();
  thread_.wait();
}

void RenderThread::post(Work work) {
  QMetaObject::invokeMethod(&place_, std::move(work), Qt::QueuedConnection);
}

void RenderThread::finish(Work work) {
  if (apart_) {
    QMetaObject::invokeMethod(&place_, std::move(work), Qt::BlockingQueuedConnection);
  } else {
    QCoreApplication::sendPostedEvents(&place_, QEvent::MetaCall);
    work();
  }
}

}  // namespace vantage
