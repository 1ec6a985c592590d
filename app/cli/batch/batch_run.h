#pragma once

#include <string>
#include <vector>

#include "cli/batch/batch_jobs.h"
#include "cli/batch/job_record.h"
#include "cli/command.h"

namespace vantage {

struct BatchOptions {
  int atATime = 1;      ///< jobs that run beside each other
  int threads = 1;      ///< of each
  bool goOn = false;    ///< with jobs that were begun before; otherwise none may have been
  std::string program;  ///< file of vantage-cli
};

/// Runs jobs as programs of their own, so many at a time and in their order. A job that fails stops no other. What
/// became of each is written to job.json in its folder after every step, and what it said to log.txt.
/// @throws InvalidInput when a job was begun before and `goOn` is not set, or was begun as another job; nothing has run
/// then. IoError. Cancelled: all have ended, and can be gone on with
void runBatch(const BatchFile& file, const std::vector<const BatchJob*>& jobs, const BatchOptions& options,
              CommandContext& context);

/// Folder of a job's results.
[[nodiscard]] std::string folderOf(const BatchFile& file, const BatchJob& job);

}  // namespace vantage
