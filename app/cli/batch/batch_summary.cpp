#include "cli/batch/batch_summary.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/plain_text.h"
#include "cli/batch/batch_run.h"
#include "cli/text.h"
#include "report/html_parts.h"
#include "report/svg_chart.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A column of the table: member of the JSON, title, and decimals of its numbers.
struct Column {
  const char* key;
  const char* title;
  int decimals = 0;
};
constexpr std::array<Column, 14> kColumns{{{"job", "Job"},
                                           {"status", "Status"},
                                           {"exit_code", "Exit code"},
                                           {"failed_step", "Failed step"},
                                           {"seconds", "Time [s]", 1},
                                           {"views", "Views"},
                                           {"rejected", "Rejected"},
                                           {"ended", "Ended"},
                                           {"covered", "Covered of what can be scanned", 4},
                                           {"triangles", "Triangles"},
                                           {"boundary_edges", "Boundary edges"},
                                           {"area_mm2", "Area [mm²]", 1},
                                           {"warnings", "Warnings"},
                                           {"message", "Message"}}};

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em;color:#1d2733}table{border-collapse:collapse}"
    "th,td{padding:.3em .8em;border-bottom:1px solid #ccd3da;text-align:left;vertical-align:top}"
    "tr.failed td,tr.cancelled td{background:#fbe9e7}tr.done_but td{background:#fff6e0}";

Json jobJson(const BatchResult& result) {
  Json json = Json::object();
  for (const Column& column : kColumns) json[column.key] = nullptr;
  json["job"] = result.job->name;
  json["status"] = statusOf(result.record, *result.job);
  if (!result.record) return json;
  const JobRecord& record = *result.record;
  double seconds = 0.0;
  int code = 0;
  for (const StepRecord& step : record.steps) {
    seconds += step.seconds;
    code = std::max(code, wentWell(step.exitCode) ? step.exitCode : 0);
    if (!wentWell(step.exitCode)) json["failed_step"] = step.command;
  }
  if (!record.steps.empty())
    json["exit_code"] = wentWell(record.steps.back().exitCode) ? code : record.steps.back().exitCode;
  json["seconds"] = seconds;
  if (!record.message.empty()) json["message"] = record.message;
  for (const auto& [key, value] : record.figures.items())
    if (json.contains(key)) json[key] = value;
  return json;
}

std::string valueText(const Json& value, int decimals) {
  if (value.is_null()) return {};
  if (value.is_string()) return plainText(value.get<std::string>());
  return value.is_number_float() ? decimalText(value.get<double>(), decimals) : value.dump();
}

std::string csvCell(std::string text, bool isText) {
  if (isText && !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
    text.insert(text.begin(), '\'');
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string reportOf(const BatchFile& file, const BatchJob& job) {
  for (const BatchStep& step : job.steps) {
    if (step.command != "report") continue;
    const fs::path report = fs::path(job.name) / step.arguments.front();
    if (fs::exists(fs::path(file.out) / report)) return report.generic_string();
  }
  return {};
}

// A path as a link has it.
std::string linkTo(const std::string& path) {
  std::string link;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) {
      link += c;
      continue;
    }
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    link += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return link;
}

}  // namespace

std::vector<BatchResult> batchResults(const BatchFile& file) {
  std::vector<BatchResult> results;
  for (const BatchJob& job : file.jobs) results.push_back({&job, readJobRecord(folderOf(file, job))});
  return results;
}

std::size_t countStatus(const std::vector<BatchResult>& results, const std::string& status) {
  return static_cast<std::size_t>(std::count_if(results.begin(), results.end(), [&](const BatchResult& result) {
    return statusOf(result.record, *result.job) == status;
  }));
}

Json summaryJson(const std::vector<BatchResult>& results) {
  Json jobs = Json::array();
  for (const BatchResult& result : results) jobs.push_back(jobJson(result));
  return {{"jobs", jobs}};
}

std::string summaryCsv(const Json& summary) {
  std::string csv;
  for (const Column& column : kColumns) csv += (csv.empty() ? "" : ",") + std::string(column.key);
  csv += "\n";
  for (const Json& job : summary["jobs"]) {
    std::string line;
    for (const Column& column : kColumns) {
      const Json& value = job[column.key];
      if (&column != kColumns.data()) line += ",";
      line += csvCell(valueText(value, column.decimals), value.is_string());
    }
    csv += line + "\n";
  }
  return csv;
}

std::string summaryHtml(const Json& summary, const std::vector<std::string>& reports) {
  std::vector<std::string> titles;
  for (const Column& column : kColumns) titles.emplace_back(column.title);
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Batch</title><style>" +
                     std::string(kStyle) + "</style></head><body>\n<h1>Batch</h1>\n<table>\n" + htmlRow(titles, "th");
  for (std::size_t i = 0; i < summary["jobs"].size(); ++i) {
    const Json& job = summary["jobs"][i];
    html += "<tr class=\"" + job["status"].get<std::string>() + "\">";
    for (const Column& column : kColumns) {
      std::string text = escapedHtml(valueText(job[column.key], column.decimals));
      if (&column == kColumns.data() && !reports[i].empty())
        text = "<a href=\"" + linkTo(reports[i]) + "\">" + text + "</a>";
      html += htmlCell(text);
    }
    html += "</tr>\n";
  }
  return html + "</table>\n</body></html>\n";
}

void writeSummary(const BatchFile& file, const std::vector<BatchResult>& results) {
  const Json summary = summaryJson(results);
  std::vector<std::string> reports;
  for (const BatchResult& result : results) reports.push_back(reportOf(file, *result.job));
  const auto at = [&](const char* name) { return (fs::path(file.out) / name).string(); };
  writeTextFile(at("summary.json"), summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  writeTextFile(at("summary.csv"), summaryCsv(summary));
  writeTextFile(at("summary.html"), summaryHtml(summary, reports));
}

}  // namespace vantage
