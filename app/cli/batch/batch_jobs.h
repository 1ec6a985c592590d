#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vantage {

/// One call of vantage-cli.
struct BatchStep {
  std::string command;                 ///< "acquire", "import", "export", "report"
  std::vector<std::string> arguments;  ///< without those that the batch adds: where things go, threads, --json
};

/// What is to be made of one object, in a folder of its own.
struct BatchJob {
  std::string name;
  std::string session;               ///< file: its own, or one that is there already
  std::vector<BatchStep> steps;      ///< in their order; each needs the one before
  nlohmann::ordered_json described;  ///< as the file says it, with what the file says for all jobs
};

/// A file of jobs:
/// { "out": DIR, "all": {...}, "jobs": [ { "name": N, "acquire": {...} | "import": {...} | "session": FILE,
///   "export": [FILE, ...], "report": true | FILE }, ... ] }
/// `acquire` and `import` have the options of these commands by their names, "set" an object of settings, and the scans
/// of an import are "range". "all" has members that jobs have where they do not say them themselves. Paths of the file
/// are relative to its folder; exports and reports go into the folder of their job.
struct BatchFile {
  std::string folder;          ///< of the file, absolute
  std::string out;             ///< absolute; without "out" beside the file with its name
  std::vector<BatchJob> jobs;  ///< their names differ
};

/// @param app has the commands: what they do not know is refused before anything runs
/// @param out instead of what the file says; empty: as it says
/// @throws IoError; InvalidInput that names file, JSON pointer and what was expected
[[nodiscard]] BatchFile readBatchFile(const std::string& path, const std::string& out, const CLI::App& app);

}  // namespace vantage
