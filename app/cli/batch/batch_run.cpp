#include "cli/batch/batch_run.h"

#include <chrono>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <list>
#include <thread>
#include <utility>

#include "base/errors.h"
#include "cli/batch/child_program.h"
#include "cli/batch/step_call.h"
#include "cli/text.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr std::chrono::milliseconds kPoll{20};
constexpr std::chrono::seconds kGrace{120};  // between asking programs to end and killing them
constexpr std::size_t kMostSaid = 65536;

// The last thing that a program said of itself, without its name.
std::string lastSaid(const std::string& log, std::streamoff from) {
  std::ifstream in(log, std::ios::binary);
  in.seekg(from);
  std::string text(kMostSaid, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  constexpr std::string_view kName = "vantage-cli: ";
  if (const std::size_t found = text.rfind(kName); found != std::string::npos) text.erase(0, found + kName.size());
  return text.substr(0, text.find('\n'));
}

// A job under way: at most one of its steps runs.
class RunningJob {
 public:
  RunningJob(const BatchFile& file, const BatchJob& job, const BatchOptions& options)
      : file_(file), job_(job), options_(options), folder_(folderOf(file, job)) {
    fs::create_directories(folder_);
    if (auto record = readJobRecord(folder_)) record_ = std::move(*record);
    const std::size_t done = record_.done();
    record_.steps.resize(done);
    record_.message.clear();
    record_.described = job.described;
    writeJobRecord(record_, folder_);
  }

  // Goes on as far as it can now. @return whether the job has ended
  bool goOn() {
    if (child_ && !stepEnded()) return false;
    if (ended_ || record_.steps.size() == job_.steps.size()) return true;
    begin(job_.steps[record_.steps.size()]);
    return ended_;
  }
  // Whether none of its steps runs any more; the next is not begun.
  bool idle() { return !child_ || stepEnded(); }
  void askToEnd() const {
    if (child_) child_->askToEnd();
  }
  [[nodiscard]] const BatchJob& job() const { return job_; }
  [[nodiscard]] const JobRecord& record() const { return record_; }

 private:
  void begin(const BatchStep& step) {
    begun_ = Clock::now();
    result_ = (fs::path(folder_) / (std::to_string(record_.steps.size() + 1) + "_" + step.command + ".json")).string();
    std::error_code missing;
    const auto said = fs::file_size(log(), missing);
    logBefore_ = missing ? 0 : static_cast<std::streamoff>(said);
    try {
      const StepPlace place{options_.program, folder_, job_.session, options_.threads};
      child_.emplace(callOf(step, place, Progress()), ChildProgram::Places{file_.folder, result_, log()});
    } catch (const Error& e) {
      fail(e.what());
    }
  }

  // Whether the step that ran has ended; what came of it is written then.
  bool stepEnded() {
    const std::optional<int> code = child_->ended();
    if (!code) return false;
    child_.reset();
    const BatchStep& step = job_.steps[record_.steps.size()];
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    record_.steps.push_back({step.command, *code, seconds});
    if (step.command == "acquire" || step.command == "import") record_.figures = figuresOf(resultOf());
    if (!wentWell(*code)) {
      record_.message = lastSaid(log(), logBefore_);
      if (record_.message.empty()) record_.message = "ended with exit code " + std::to_string(*code);
      ended_ = true;
    }
    writeJobRecord(record_, folder_);
    return true;
  }

  void fail(const std::string& why) {
    record_.message = why;
    ended_ = true;
    writeJobRecord(record_, folder_);
  }

  [[nodiscard]] std::string log() const { return (fs::path(folder_) / "log.txt").string(); }
  [[nodiscard]] Json resultOf() const {
    std::ifstream in(result_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return Json::parse(text, nullptr, false);  // of a command that failed there is none
  }

  const BatchFile& file_;
  const BatchJob& job_;
  const BatchOptions& options_;
  std::string folder_;
  JobRecord record_;
  std::string result_;
  std::streamoff logBefore_ = 0;
  Clock::time_point begun_;
  std::optional<ChildProgram> child_;
  bool ended_ = false;
};

void checkBegun(const BatchFile& file, const std::vector<const BatchJob*>& jobs, bool goOn) {
  for (const BatchJob* job : jobs) {
    const std::string folder = folderOf(file, *job);
    const auto record = readJobRecord(folder);
    if (!record) continue;
    if (!goOn)
      throw InvalidInput(folder +
                         ": has results of this job already: go on with --resume, or choose another folder (--out)");
    if (record->described != job->described)
      throw InvalidInput(folder + ": was begun as another job than " + job->name +
                         " is now: give the job another name, or choose another folder (--out)");
  }
}

std::string lineOf(const RunningJob& ended, std::size_t done, std::size_t all) {
  std::string line = ended.job().name + ": " + statusOf(ended.record(), ended.job());
  if (!ended.record().message.empty()) line += ": " + ended.record().message;
  return line + " (" + std::to_string(done) + " of " + std::to_string(all) + ")";
}

// What ended makes room for the next.
void reap(std::list<RunningJob>& running, std::size_t& ended, std::size_t all, CommandContext& context) {
  for (auto job = running.begin(); job != running.end();) {
    if (job->goOn()) {
      context.note(lineOf(*job, ++ended, all));
      job = running.erase(job);
    } else {
      ++job;
    }
  }
}

// All programs end, each where it can be gone on with.
void endAll(std::list<RunningJob>& running) {
  for (const RunningJob& job : running) job.askToEnd();
  const auto deadline = Clock::now() + kGrace;
  while (!running.empty() && Clock::now() < deadline) {
    for (auto job = running.begin(); job != running.end();) job = job->idle() ? running.erase(job) : std::next(job);
    std::this_thread::sleep_for(kPoll);
  }
}

}  // namespace

std::string folderOf(const BatchFile& file, const BatchJob& job) {
  return (fs::path(file.out) / job.name).string();
}

void runBatch(const BatchFile& file, const std::vector<const BatchJob*>& jobs, const BatchOptions& options,
              CommandContext& context) {
  checkBegun(file, jobs, options.goOn);
  const Progress progress = context.progress().part(0.0, 1.0, "jobs");
  std::deque<const BatchJob*> waiting(jobs.begin(), jobs.end());
  std::list<RunningJob> running;
  std::size_t ended = 0;
  try {
    while (!waiting.empty() || !running.empty()) {
      progress.checkpoint(static_cast<double>(ended) / static_cast<double>(jobs.size()));
      while (!waiting.empty() && running.size() < static_cast<std::size_t>(options.atATime)) {
        running.emplace_back(file, *waiting.front(), options);
        waiting.pop_front();
      }
      reap(running, ended, jobs.size(), context);
      if (!running.empty()) std::this_thread::sleep_for(kPoll);
    }
  } catch (const Cancelled&) {
    endAll(running);
    throw;
  }
}

}  // namespace vantage
