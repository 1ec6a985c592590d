#include "acquisition/patient_scanner.h"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
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

// What the thread that waits shares with the one that scans.
struct Conversation {
  std::mutex mutex;
  std::condition_variable changed;
  std::chrono::steady_clock::time_point heard = std::chrono::steady_clock::now();
  double fraction = 0.0;
  std::optional<RangeImage> image;
  std::exception_ptr error;
  bool done = false;

  void hear(double newFraction) {
    const std::lock_guard lock(mutex);
    heard = std::chrono::steady_clock::now();
    fraction = newFraction;
  }

  void finish(std::optional<RangeImage> result, std::exception_ptr failure) {
    const std::lock_guard lock(mutex);
    image = std::move(result);
    error = std::move(failure);
    done = true;
    changed.notify_all();
  }
};

void scanAlone(const std::shared_ptr<ScannerDevice>& scanner, int position, const Progress& inner,
               const std::shared_ptr<Conversation>& talk) {
  try {
    talk->finish(scanner->scan(position, inner), nullptr);
  } catch (...) {
    talk->finish(std::nullopt, std::current_exception());
  }
}

}  // namespace

RangeImage PatientScanner::scan(int position, const Progress& progress) {
  if (givenUp_) throw DeviceError("the scanner has not come back since it stopped answering; start it again");
  progress.checkpoint(0.0);
  const auto talk = std::make_shared<Conversation>();
  std::stop_source stop;
  const Progress inner([talk](double fraction, std::string_view /*step*/) { talk->hear(fraction); }, stop.get_token(),
                       progress.threads());
  // Detached: a device that hangs must not take the program with it.
  std::thread([scanner = scanner_, position, inner, talk] { scanAlone(scanner, position, inner, talk); }).detach();

  std::unique_lock lock(talk->mutex);
  while (!talk->changed.wait_for(lock, kLook, [&] { return talk->done; })) {
    const bool silent = std::chrono::steady_clock::now() - talk->heard > patience_;
    const double fraction = talk->fraction;
    if (silent || progress.stopRequested()) {
      stop.request_stop();
      talk->changed.wait_for(lock, kGrace, [&] { return talk->done; });
      givenUp_ = !talk->done;
    }
    if (silent && givenUp_)
      throw DeviceError("the scanner has not answered for " + seconds(patience_) + " s at position " +
                        std::to_string(position) + "; the session is whole, go on when it is back");
    lock.unlock();
    progress.checkpoint(fraction);
    lock.lock();
  }
  if (talk->error) std::rethrow_exception(talk->error);
  return std::move(*talk->image);
}

}  // namespace vantage
