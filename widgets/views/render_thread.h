#pragma once

#include <QObject>
#include <QThread>
#include <functional>

namespace vantage {

/// The thread that scenes are drawn on, one after the other. Made, used and destroyed on the UI thread.
class RenderThread {
 public:
  using Work = std::function<void()>;

  /// @param apart false: draws on the UI thread, between its events
  explicit RenderThread(bool apart = true);
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  /// Does something after everything that was posted before.
  void post(Work work);
  /// The same, and waits for it.
  void finish(Work work);

 private:
  bool apart_;
  QThread thread_;
  QObject place_;  // lives where the work is done
};

}  // namespace vantage
