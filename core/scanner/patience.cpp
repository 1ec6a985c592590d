#include "scanner/patience.h"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr std::chrono::milliseconds kLook{20};
// A device that listens ends within this when it is asked to stop.
constexpr std::chrono::milliseconds kGrace{300};

std::string seconds(std::chrono::milliseconds duration) {
  const std::int64_t tenths = duration.count() / 100;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

// What the thread that waits shares with the one that works.
struct Patience::Conversation {
  std::mutex mutex;
  std::condition_variable changed;
  std::chrono::steady_clock::time_point heard = std::chrono::steady_clock::now();
  double fraction = 0.0;
  std::string step;
  std::exception_ptr error;
  bool done = false;

  void hear(double newFraction, std::string_view newStep) {
    const std::lock_guard lock(mutex);
    heard = std::chrono::steady_clock::now();
    fraction = newFraction;
    step = newStep;
  }

  void finish(std::exception_ptr failure) {
    const std::lock_guard lock(mutex);
    error = std::move(failure);
    done = true;
    changed.notify_all();
  }

  // Detached: a device that hangs must not take the program with it.
  static void begin(const std::shared_ptr<Conversation>& talk, std::function<void()> work) {
    std::thread([talk, work = std::move(work)]() mutable {
      std::exception_ptr failure;
      try {
        work();
      } catch (...) {
        failure = std::current_exception();
      }
      // What the work holds goes before anybody hears that it is done.
      work = nullptr;
      talk->finish(std::move(failure));
    }).detach();
  }
};

bool Patience::hanging() const {
  if (!last_) return false;
  const std::lock_guard lock(last_->mutex);
  return !last_->done;
}

void Patience::run(const std::string& doing, std::function<void(const Progress&)> work, const Progress& progress) {
  if (hanging())
    throw DeviceError(device_ + " has not come back since it stopped answering; start it again, or wait for it");
  last_.reset();
  progress.checkpoint(0.0);
  const auto talk = std::make_shared<Conversation>();
  std::stop_source stop;
  const Progress inner([talk](double fraction, std::string_view step) { talk->hear(fraction, step); }, stop.get_token(),
                       progress.threads());
  Conversation::begin(talk, [work = std::move(work), inner] { work(inner); });
  try {
    await(*talk, stop, doing, progress);
  } catch (...) {
    last_ = talk;
    throw;
  }
}

// Looks up now and then; whoever throws here leaves the device behind.
void Patience::await(Conversation& talk, std::stop_source& stop, const std::string& doing, const Progress& progress) {
  std::unique_lock lock(talk.mutex);
  while (!talk.changed.wait_for(lock, kLook, [&] { return talk.done; })) {
    const bool silent = std::chrono::steady_clock::now() - talk.heard > patience_;
    const double fraction = talk.fraction;
    const std::string step = talk.step;
    if (silent || progress.stopRequested()) {
      stop.request_stop();
      talk.changed.wait_for(lock, kGrace, [&] { return talk.done; });
    }
    // A device that listened ends with Cancelled, which nobody asked for.
    if (silent && !(talk.done && !talk.error))
      throw DeviceError(device_ + " has not answered for " + seconds(patience_) + " s while " + doing +
                        "; nothing that was scanned is lost, go on when it is back");
    lock.unlock();
    progress.part(0.0, 1.0, step).checkpoint(fraction);
    lock.lock();
  }
  if (talk.error) std::rethrow_exception(talk.error);
}

void Patience::runBriefly(std::function<void()> work) noexcept {
  try {
    const auto talk = std::make_shared<Conversation>();
    Conversation::begin(talk, std::move(work));
    std::unique_lock lock(talk->mutex);
    talk->changed.wait_for(lock, kGrace, [&] { return talk->done; });
  } catch (...) {
    // Without a thread to be had nothing is left to do for it.
  }
}

}  // namespace vantage
