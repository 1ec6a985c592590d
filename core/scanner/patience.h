#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/progress.h"

namespace vantage {

/// Waits for a device as long as it shows signs of life: progress or a result. The device works on a thread of its own;
/// one that is given up is left to itself there until it comes back, however late. What it brings then is dropped, and
/// it can be used again.
class Patience {
 public:
  /// @param device its identity, which messages begin with.
  Patience(std::string device, std::chrono::milliseconds patience) : device_(std::move(device)), patience_(patience) {}

  /// What `work` returns. @param work keeps alive all that it uses; its progress is only good for reporting, asking
  /// for a stop and the number of threads.
  /// @param doing the end of "has not answered for 2.0 s while ...".
  /// @throws whatever the work throws; DeviceError when the device does not answer, or did not the last time and has
  /// not come back since; Cancelled soon, whether the device listens or not.
  template <typename T>
  [[nodiscard]] T call(const std::string& doing, std::function<T(const Progress&)> work, const Progress& progress) {
    const auto result = std::make_shared<std::optional<T>>();
    run(
        doing, [result, work = std::move(work)](const Progress& inner) { *result = work(inner); }, progress);
    return std::move(**result);
  }

  /// The same of work without a result.
  void run(const std::string& doing, std::function<void(const Progress&)> work, const Progress& progress);

  /// Lets work that throws nothing begin and waits for it only for a moment, for who must leave now.
  void runBriefly(std::function<void()> work) noexcept;

  /// Whether the device was given up and has not come back.
  [[nodiscard]] bool hanging() const;

 private:
  struct Conversation;
  void await(Conversation& talk, std::stop_source& stop, const std::string& doing, const Progress& progress);

  std::string device_;
  std::chrono::milliseconds patience_;
  std::shared_ptr<Conversation> last_;  // with a device that was given up
};

}  // namespace vantage
