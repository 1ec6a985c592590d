#include "cli/batch/job_record.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/errors.h"
#include "cli/text.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kDone = 0;
constexpr int kCancelled = 3;
constexpr int kDoneBut = 4;

std::string fileIn(const std::string& folder) {
  return (fs::path(folder) / "job.json").string();
}

void copyMember(const Json& from, const char* key, Json& to, const char* as) {
  if (const auto member = from.find(key); member != from.end()) to[as] = *member;
}

// "a, b" of the codes of warnings, each once.
std::string codesOf(const Json& warnings) {
  std::vector<std::string> codes;
  for (const Json& warning : warnings) {
    const std::string code = warning.value("code", "");
    if (std::find(codes.begin(), codes.end(), code) == codes.end()) codes.push_back(code);
  }
  std::string text;
  for (const std::string& code : codes) text += (text.empty() ? "" : ", ") + code;
  return text;
}

}  // namespace

bool wentWell(int exitCode) {
  return exitCode == kDone || exitCode == kDoneBut;
}

std::size_t JobRecord::done() const {
  return static_cast<std::size_t>(
      std::find_if(steps.begin(), steps.end(), [](const StepRecord& s) { return !wentWell(s.exitCode); }) -
      steps.begin());
}

std::string statusOf(const std::optional<JobRecord>& record, const BatchJob& job) {
  if (!record) return "not_run";
  for (const StepRecord& step : record->steps)
    if (!wentWell(step.exitCode)) return step.exitCode == kCancelled ? "cancelled" : "failed";
  if (!record->message.empty()) return "failed";
  if (record->steps.size() < job.steps.size()) return "running";
  const bool all =
      std::all_of(record->steps.begin(), record->steps.end(), [](const auto& s) { return s.exitCode == kDone; });
  return all ? "done" : "done_but";
}

std::optional<JobRecord> readJobRecord(const std::string& folder) {
  std::ifstream in(fileIn(folder), std::ios::binary);
  if (!in) return std::nullopt;
  try {
    const Json json = Json::parse(std::string{std::istreambuf_iterator<char>(in), {}});
    JobRecord record{json.at("job"), {}, json.at("message"), json.at("figures")};
    for (const Json& step : json.at("steps"))
      record.steps.push_back({step.at("command"), step.at("exit_code"), step.at("seconds")});
    return record;
  } catch (const Json::exception& e) {
    throw InvalidInput(fileIn(folder) + ": is no record of a job: " + e.what());
  }
}

void writeJobRecord(const JobRecord& record, const std::string& folder) {
  Json json{
      {"job", record.described}, {"steps", Json::array()}, {"message", record.message}, {"figures", record.figures}};
  for (const StepRecord& step : record.steps)
    json["steps"].push_back({{"command", step.command}, {"exit_code", step.exitCode}, {"seconds", step.seconds}});
  writeTextFile(fileIn(folder), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Json figuresOf(const Json& result) {
  Json figures = Json::object();
  if (!result.is_object()) return figures;
  if (const auto views = result.find("views"); views != result.end() && views->is_array())
    figures["views"] = views->size();
  if (const auto scans = result.find("scans"); scans != result.end() && scans->is_array()) {
    const auto failed =
        std::count_if(scans->begin(), scans->end(), [](const Json& s) { return s.value("verdict", "") == "failed"; });
    figures["views"] = scans->size() - static_cast<std::size_t>(failed);
    figures["rejected"] = failed;
  }
  copyMember(result, "terminated_by", figures, "ended");
  if (const auto model = result.find("model"); model != result.end())
    for (const char* key : {"triangles", "boundary_edges", "area_mm2"}) copyMember(*model, key, figures, key);
  if (const auto complete = result.find("completeness"); complete != result.end())
    copyMember(*complete, "scannable_covered", figures, "covered");
  if (const auto warnings = result.find("warnings"); warnings != result.end()) figures["warnings"] = codesOf(*warnings);
  return figures;
}

}  // namespace vantage
