#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vantage {

void parallelChunks(std::size_t count, std::size_t grain, const Progress& progress,
                    const std::function<void(std::size_t, std::size_t)>& body) {
  progress.checkpoint(0.0);
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = (count + grain - 1) / grain;

  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::size_t failedChunk = chunks;
  std::exception_ptr error;

  auto work = [&] {
    while (!failed.load(std::memory_order_relaxed)) {
      const std::size_t chunk = next.fetch_add(1, std::memory_order_relaxed);
      if (chunk >= chunks) return;
      try {
        progress.checkpoint(static_cast<double>(chunk) / static_cast<double>(chunks));
        body(chunk * grain, std::min(count, (chunk + 1) * grain));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (chunk < failedChunk) {
          failedChunk = chunk;
          error = std::current_exception();
        }
        failed = true;
      }
    }
  };

  const auto helpers = std::min<std::size_t>(static_cast<std::size_t>(progress.threads()), chunks) - 1;
  std::vector<std::jthread> threads;
  threads.reserve(helpers);
  for (std::size_t i = 0; i < helpers; ++i) threads.emplace_back(work);
  work();
  threads.clear();
  if (error) std::rethrow_exception(error);
}

}  // namespace vantage
