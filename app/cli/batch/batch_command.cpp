#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/errors.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/batch_summary.h"
#include "cli/command.h"
#include "program/installed_files.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr int kMostAtATime = 256;

struct BatchArguments {
  std::string file;
  std::string out;
  std::vector<std::string> only;
  int jobs = 1;
  bool resume = false;
  bool list = false;
  bool summary = false;
};

std::vector<const BatchJob*> chosenJobs(const BatchFile& file, const std::vector<std::string>& only) {
  std::vector<const BatchJob*> chosen;
  for (const BatchJob& job : file.jobs)
    if (only.empty() || std::find(only.begin(), only.end(), job.name) != only.end()) chosen.push_back(&job);
  for (const std::string& name : only)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const BatchJob* job) { return job->name == name; }))
      throw InvalidInput("--only is \"" + name + "\": no job has that name; --list lists them");
  return chosen;
}

void listJobs(const BatchFile& file, CommandContext& context) {
  nlohmann::ordered_json json{{"jobs", nlohmann::ordered_json::array()}};
  std::string text;
  for (const BatchJob& job : file.jobs) {
    json["jobs"].push_back(job.name);
    text += job.name + "\n";
  }
  context.result(json, text);
}

std::vector<BatchResult> resultsOf(const std::vector<const BatchJob*>& jobs, const BatchFile& file) {
  std::vector<BatchResult> results = batchResults(file);
  std::erase_if(results, [&](const BatchResult& result) {
    return std::find(jobs.begin(), jobs.end(), result.job) == jobs.end();
  });
  return results;
}

std::string namesOf(const std::vector<BatchResult>& results, const std::string& status) {
  std::string names;
  for (const BatchResult& result : results)
    if (statusOf(result.record, *result.job) == status) names += (names.empty() ? "" : ", ") + result.job->name;
  return names;
}

// Says what came of the jobs, and fails when one of them did.
void tell(const BatchFile& file, const std::vector<BatchResult>& results, bool written, CommandContext& context) {
  nlohmann::ordered_json json = summaryJson(results);
  std::string text;
  for (const char* status : {"done", "done_but", "failed", "cancelled", "running", "not_run"}) {
    const std::size_t count = countStatus(results, status);
    json[status] = count;
    if (count > 0) text += std::string(status) + ": " + std::to_string(count) + " (" + namesOf(results, status) + ")\n";
  }
  if (written) text += "written: " + (fs::path(file.out) / "summary.{json,csv,html}").string() + "\n";
  std::vector<Remark> remarks;
  if (const std::string names = namesOf(results, "done_but"); !names.empty())
    remarks.push_back({"jobs_done_but", "done, but not all is well: " + names + "; the summary says what", {}, true});
  context.result(json, text, remarks);
  const std::size_t failed = countStatus(results, "failed");
  if (failed > 0)
    throw Error(std::to_string(failed) + " of " + std::to_string(results.size()) + " jobs failed: " +
                namesOf(results, "failed") + "; log.txt in the folder of each says why, --resume tries again");
}

void run(const BatchArguments& args, const CLI::App& app, CommandContext& context) {
  const BatchFile file = readBatchFile(args.file, args.out, app);
  if (args.list) return listJobs(file, context);
  const std::vector<const BatchJob*> jobs = chosenJobs(file, args.only);
  // Of jobs that run elsewhere at the same time only a call of its own sums up.
  const bool writes = args.only.empty();
  const auto finish = [&] {
    if (writes) writeSummary(file, batchResults(file));
  };
  if (!args.summary) {
    BatchOptions options{args.jobs, std::max(1, context.threads() / args.jobs), args.resume, programFile().string()};
    try {
      runBatch(file, jobs, options, context);
    } catch (const Cancelled&) {
      finish();
      throw;
    }
  }
  finish();
  tell(file, resultsOf(jobs, file), writes, context);
}

}  // namespace

void addBatchCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<BatchArguments>();
  CLI::App* command = app.add_subcommand(
      "batch", "Acquire or import, export and report on many objects, several at a time, and sum up what came of them");
  command->add_option("jobs", args->file, "What is to be done (JSON)")->required();
  command->add_option("--jobs", args->jobs, "Jobs that run at a time; they share the threads")
      ->check(CLI::Range(1, kMostAtATime))
      ->capture_default_str();
  CLI::Option* resume =
      command->add_flag("--resume", args->resume,
                        "Go on with jobs that were begun before, try again what failed, leave alone what is done");
  command->add_option("--out", args->out, "Folder for a folder per job and the summary, instead of what the file says");
  command->add_option("--only", args->only, "Only the job of this name, without a summary; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  CLI::Option* list =
      command->add_flag("--list", args->list, "Do nothing but list the names of the jobs, one to a line");
  CLI::Option* summary =
      command->add_flag("--summary", args->summary, "Do nothing but sum up what has come of all jobs so far");
  list->excludes(summary)->excludes(resume);
  summary->excludes(resume);
  context.addCommonOptions(*command);
  command->callback([args, &app, &context] { run(*args, app, context); });
}

}  // namespace vantage
