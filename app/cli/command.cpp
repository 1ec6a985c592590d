#include "cli/command.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>
#include <utility>

#include "base/errors.h"
#include "base/plain_text.h"
#include "report/wording.h"

namespace vantage {
namespace {

constexpr int kMaxThreads = 256;

int machineThreads() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
}

}  // namespace

CommandContext::CommandContext(std::stop_token stop, std::vector<std::string> arguments)
    : stop_(std::move(stop)),
      arguments_(std::move(arguments)),
      bar_(ProgressBar::terminal()),
      threads_(machineThreads()) {}

void CommandContext::addCommonOptions(CLI::App& command) {
  command.add_flag("--json", json_, "Print the result on stdout as one JSON object");
  command.add_option("--threads", threads_, "Threads to use; results never depend on it")
      ->check(CLI::Range(1, kMaxThreads))
      ->capture_default_str();
}

Progress CommandContext::progress() {
  return {[this](double fraction, std::string_view step) { bar_.show(fraction, step); }, stop_, threads_};
}

void CommandContext::result(const nlohmann::ordered_json& json, const std::string& text) {
  bar_.clear();
  if (events_) return note(text);
  const std::string out =
      json_ ? json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n" : plainLines(text);
  if (std::fputs(out.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw IoError("standard output", std::string("cannot be written: ") + std::strerror(errno));
}

void CommandContext::result(nlohmann::ordered_json json, const std::string& text,
                            const std::vector<Warning>& warnings) {
  std::vector<Remark> remarks;
  for (const Warning& warning : warnings) {
    std::optional<std::size_t> scan;
    if (warning.scan) scan = static_cast<std::size_t>(*warning.scan);
    remarks.push_back({std::string(name(warning.code)), describe(warning), scan, isSerious(warning)});
  }
  result(std::move(json), text, remarks);
}

void CommandContext::result(nlohmann::ordered_json json, const std::string& text, const std::vector<Remark>& remarks) {
  json["warnings"] = nlohmann::ordered_json::array();
  for (const Remark& remark : remarks) {
    nlohmann::ordered_json item{{"code", remark.code}, {"text", remark.text}};
    if (remark.scan) item["scan"] = *remark.scan;
    json["warnings"].push_back(std::move(item));
    note("warning: " + remark.text);
    warned_ = warned_ || remark.serious;
  }
  result(json, text);
}

void CommandContext::note(const std::string& line) {
  bar_.clear();
  std::fprintf(stderr, "%s\n", plainLines(line).c_str());
}

}  // namespace vantage
