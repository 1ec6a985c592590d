#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "base/errors.h"
#include "scanner/rig.h"

namespace vantage::testing {

/// What a test and its stuck devices share.
struct Stuck {
  std::atomic<bool> go = false;       ///< lets go of what is stuck
  std::atomic<bool> alive = false;    ///< progress is shown meanwhile, and a stop answered
  std::atomic<bool> listens = false;  ///< a stop is answered meanwhile
  std::atomic<bool> inClose = false;  ///< closing gets stuck as well
  std::atomic<int> gone = 0;          ///< how many devices were destroyed

  void waitForGo() const noexcept {
    while (!go) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  void wait(const Progress& progress) const {
    while (!go) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (alive) progress.checkpoint(0.5);
      if (listens && progress.stopRequested()) throw Cancelled();
    }
  }
};

/// A device that does not answer until it is let go.
template <typename Kind>
class StuckDevice : public Kind {
 public:
  explicit StuckDevice(std::shared_ptr<Stuck> stuck) : stuck_(std::move(stuck)) {}
  ~StuckDevice() override { ++stuck_->gone; }

  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {
    if (stuck_->inClose) stuck_->waitForGo();
  }
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }

 protected:
  std::shared_ptr<Stuck> stuck_;
};

class StuckSensor final : public StuckDevice<RangeSensor> {
 public:
  using StuckDevice::StuckDevice;
  [[nodiscard]] std::string identity() const override { return "stuck sensor"; }
  [[nodiscard]] RangeImage capture(const Progress& progress) override {
    stuck_->wait(progress);
    return {};
  }
};

class StuckTable final : public StuckDevice<Positioner> {
 public:
  using StuckDevice::StuckDevice;
  [[nodiscard]] std::string identity() const override { return "stuck table"; }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override {
    stuck_->wait(progress);
    where_ = ReachedPose{position, Pose::Identity(), PoseSource::Reported, {}};
    return *where_;
  }
  [[nodiscard]] std::optional<ReachedPose> where() const override { return where_; }

 private:
  std::optional<ReachedPose> where_;
};

/// Waits up to ten seconds for something to become true.
template <typename Condition>
[[nodiscard]] bool soon(const Condition& condition) {
  for (int i = 0; i < 2000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return condition();
}

}  // namespace vantage::testing
