#include "cli/stop_signals.h"

#include <csignal>
#include <ctime>

namespace vantage {
namespace {

sigset_t stopSignalSet() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGHUP);
  return set;
}

}  // namespace

StopSignals::StopSignals() {
  const sigset_t set = stopSignalSet();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  // A reader that went away and a file that may not grow are errors of writing, said like a full disk.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  waiter_ = std::jthread([this](const std::stop_token& done) {
    const sigset_t waited = stopSignalSet();
    const timespec interval{0, 50'000'000};
    while (!done.stop_requested())
      if (sigtimedwait(&waited, nullptr, &interval) > 0) source_.request_stop();
  });
}

StopSignals::~StopSignals() = default;

}  // namespace vantage
