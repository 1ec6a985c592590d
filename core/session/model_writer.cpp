#include "session/model_writer.h"

#include <chrono>
#include <exception>
#include <system_error>
#include <utility>
#include <vector>

#include "session/session_blobs.h"

namespace vantage {

void ModelWriter::write(std::int64_t step, std::shared_ptr<const Model> model) {
  const std::lock_guard guard(mutex_);
  // The one before may be waiting for the mutex, so that it is not waited for here.
  const bool busy = written_.valid() && written_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  if (!busy) {
    try {
      // The task stays until the next one, the model does not.
      written_ = std::async(std::launch::async, [this, step, model]() mutable {
        const std::shared_ptr<const Model> taken = std::move(model);
        writeNow(step, *taken);
      });
      return;
    } catch (const std::system_error&) {
      // No thread to be had.
    }
  }
  writeNow(step, *model);
}

void ModelWriter::writeNow(std::int64_t step, const Model& model) noexcept {
  try {
    const std::vector<std::byte> blob = modelBlob(model);
    const std::lock_guard guard(mutex_);
    Database::Transaction transaction(store_.database());
    store_.addModel(step, blob);
    transaction.commit();
  } catch (const std::exception&) {
    // The next step says so if there is no room.
  }
}

void ModelWriter::settle() const {
  std::unique_lock guard(mutex_);
  const std::shared_future<void> written = written_;
  guard.unlock();
  if (written.valid()) written.wait();
}

}  // namespace vantage
