#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "cli/batch/batch_jobs.h"

namespace vantage {

/// Where a step of a job works.
struct StepPlace {
  std::string program;  ///< file of vantage-cli
  std::string folder;   ///< of the job's results
  std::string session;  ///< file
  int threads = 1;
};

/// The call that carries a step out: program and arguments. Where the session of an acquisition or import is there
/// already, it goes on with that: an acquisition is resumed, with its own devices where these are real; so is an import
/// whose scans were all kept, one that lost some is made once more, and of one that was carried out nothing is left but
/// to tell what it is.
/// @throws IoError, InvalidInput when the session cannot be opened; Cancelled
[[nodiscard]] std::vector<std::string> callOf(const BatchStep& step, const StepPlace& place, const Progress& progress);

}  // namespace vantage
