#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/batch/batch_jobs.h"
#include "cli/batch/job_record.h"

namespace vantage {

/// A job and what became of it.
struct BatchResult {
  const BatchJob* job = nullptr;
  std::optional<JobRecord> record;  ///< nothing: it was never begun
};

/// What became of all jobs of a file, in its order. @throws IoError, InvalidInput for a record that is none
[[nodiscard]] std::vector<BatchResult> batchResults(const BatchFile& file);

/// How many jobs have a status, as statusOf calls it.
[[nodiscard]] std::size_t countStatus(const std::vector<BatchResult>& results, const std::string& status);

/// { "jobs": [ { "job", "status", "exit_code", "failed_step", "seconds", "views", "rejected", "ended", "covered",
/// "triangles", "boundary_edges", "area_mm2", "warnings", "message" }, ... ] }; what is not known is null.
[[nodiscard]] nlohmann::ordered_json summaryJson(const std::vector<BatchResult>& results);

/// The same as a table with one line per job (RFC 4180, but lines end with \n). Texts that a spreadsheet would take for
/// a formula are preceded by an apostrophe.
[[nodiscard]] std::string summaryCsv(const nlohmann::ordered_json& summary);
/// The same as one page that needs no other file, with links to the reports that are there.
/// @param reports file of the report of each job, relative to the page; empty for none
[[nodiscard]] std::string summaryHtml(const nlohmann::ordered_json& summary, const std::vector<std::string>& reports);

/// Writes summary.json, summary.csv and summary.html into the folder of a batch. @throws IoError
void writeSummary(const BatchFile& file, const std::vector<BatchResult>& results);

}  // namespace vantage
