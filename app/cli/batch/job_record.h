#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/batch/batch_jobs.h"

namespace vantage {

/// What became of a step of a job.
struct StepRecord {
  std::string command;
  int exitCode = 0;  ///< of the contract
  double seconds = 0.0;
};

/// What became of a job so far; the file job.json in its folder.
struct JobRecord {
  nlohmann::ordered_json described;  ///< the job as it was begun
  std::vector<StepRecord> steps;     ///< those that ended, in their order; the last may have failed
  std::string message;               ///< of the step that failed, one line
  nlohmann::ordered_json figures;    ///< of what was acquired or imported, see figuresOf

  /// Steps that need not be done again: from the first on, as far as they went well.
  [[nodiscard]] std::size_t done() const;
};

/// "not_run", "running" (begun, and neither failed nor done), "done", "done_but", "failed", "cancelled"
[[nodiscard]] std::string statusOf(const std::optional<JobRecord>& record, const BatchJob& job);

/// Whether a step with this exit code did what it was to do.
[[nodiscard]] bool wentWell(int exitCode);

/// @return nothing when the job was never begun
/// @throws IoError, InvalidInput when the file is none
[[nodiscard]] std::optional<JobRecord> readJobRecord(const std::string& folder);
/// Whole or not at all. @throws IoError
void writeJobRecord(const JobRecord& record, const std::string& folder);

/// What a summary says of an acquisition or import, from the JSON that acquire, resume or import printed: views,
/// rejected, ended, triangles, boundary_edges, area_mm2, covered, warnings. Members that it does not have are left out.
[[nodiscard]] nlohmann::ordered_json figuresOf(const nlohmann::ordered_json& result);

}  // namespace vantage
