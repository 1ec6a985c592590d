#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "base/progress.h"
#include "scanner/range_image.h"

namespace vantage::testing {

/// A call of a device that runs on a thread of its own, as one makes it that can be stopped.
template <typename Result>
class Waiting {
 public:
  explicit Waiting(std::function<Result(const Progress&)> call)
      : progress_(
            [this](double /*fraction*/, std::string_view step) {
              const std::lock_guard lock(mutex_);
              ++reports_;
              step_ = step;
            },
            stop_.get_token(), 1),
        result_(std::async(std::launch::async, [this, call = std::move(call)] { return call(progress_); })) {}
  ~Waiting() {
    stop_.request_stop();
    if (result_.valid()) result_.wait();
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  void stop() { stop_.request_stop(); }
  [[nodiscard]] bool isOver(std::chrono::milliseconds within = std::chrono::milliseconds(0)) {
    return result_.wait_for(within) == std::future_status::ready;
  }
  /// @throws what the call threw
  [[nodiscard]] Result get() { return result_.get(); }
  [[nodiscard]] std::string step() const {
    const std::lock_guard lock(mutex_);
    return step_;
  }
  [[nodiscard]] int reports() const {
    const std::lock_guard lock(mutex_);
    return reports_;
  }
  /// Waits up to ten seconds until the step has a text in it.
  [[nodiscard]] bool says(const std::string& text) const {
    for (int i = 0; i < 1000 && step().find(text) == std::string::npos; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return step().find(text) != std::string::npos;
  }

 private:
  mutable std::mutex mutex_;
  int reports_ = 0;
  std::string step_;
  std::stop_source stop_;
  Progress progress_;
  std::future<Result> result_;
};

}  // namespace vantage::testing
