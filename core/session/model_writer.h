#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <mutex>

#include "session/session_store.h"

namespace vantage {

/// Writes the models that steps led to while whoever recorded the steps goes on. A model can be made again from its
/// step: where it cannot be written, or the program ends before, nothing is lost, and nothing is said.
class ModelWriter {
 public:
  /// @param mutex held while something is written. Both must outlive the writer, which ends when all is written.
  ModelWriter(SessionStore& store, std::recursive_mutex& mutex) : store_(store), mutex_(mutex) {}

  /// One thread calls it. While the model before is being written, or where no thread is to be had, it does not return
  /// before this one is.
  void write(std::int64_t step, std::shared_ptr<const Model> model);

  /// Waits until everything is written. Not for who holds the mutex.
  void settle() const;

 private:
  void writeNow(std::int64_t step, const Model& model) noexcept;

  SessionStore& store_;
  std::recursive_mutex& mutex_;
  std::shared_future<void> written_;  // last: it ends before the rest does
};

}  // namespace vantage
