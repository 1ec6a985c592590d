#include "devices/program_run.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <locale>
#include <sstream>
#include <thread>

#include "base/errors.h"
#include "base/plain_text.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks for it

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostOutput = 1U << 16;
constexpr std::size_t kMostSaid = 400;
constexpr std::chrono::milliseconds kGrace{200};  // between asking a program to end and killing it
constexpr int kPollMilliseconds = 20;
constexpr int kFirstOther = 3;  // descriptor behind stdin, stdout and stderr

// Both ends of a pipe.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw DeviceError(std::string("no pipe can be made for a program: ") + std::strerror(errno));
    ::fcntl(ends_[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    closeWriting();
    ::close(ends_[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }
  void closeWriting() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

  // Keeps the end of what comes; false when nothing more will.
  bool drain(std::string& text) {
    std::array<char, 4096> buffer{};
    while (true) {
      const ssize_t got = ::read(reading(), buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return got < 0 && errno == EAGAIN;
      text.append(buffer.data(), static_cast<std::size_t>(got));
      if (text.size() > 2 * kMostOutput) text.erase(0, text.size() - kMostOutput);
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

// How a program is to be started; everything that posix_spawn wants.
class SpawnSettings {
 public:
  SpawnSettings(int out, int err) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, out, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, err, STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, kFirstOther);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t signals;
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int usual : {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGCHLD}) ::sigaddset(&signals, usual);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

// A program that runs. Whatever happens here, it and its children are ended.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& run) {
    std::vector<char*> arguments;
    for (const std::string& argument : run) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const SpawnSettings settings(out_.writing(), err_.writing());
    const int failed =
        ::posix_spawnp(&process_, arguments[0], settings.actions(), settings.attributes(), arguments.data(), environ);
    if (failed != 0)
      throw DeviceError("the program " + run.front() + " cannot be started: " + std::strerror(failed) +
                        "; say its full path, and look whether it may be executed");
    out_.closeWriting();
    err_.closeWriting();
  }
  ~RunningProgram() {
    if (!ended_) kill();
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  // Waits a little for output or the end; true when it has ended.
  bool wait(ProgramEnd& end) {
    std::array<pollfd, 2> waiting{pollfd{out_.reading(), POLLIN, 0}, pollfd{err_.reading(), POLLIN, 0}};
    if (!outOpen_) waiting[0].fd = -1;
    if (!errOpen_) waiting[1].fd = -1;
    ::poll(waiting.data(), waiting.size(), kPollMilliseconds);
    drain(end);
    if (!bury(WNOHANG, end)) return false;
    drain(end);
    return true;
  }

 private:
  void drain(ProgramEnd& end) {
    if (outOpen_) outOpen_ = out_.drain(end.output);
    if (errOpen_) errOpen_ = err_.drain(end.errors);
  }

  bool bury(int options, ProgramEnd& end) {
    int status = 0;
    pid_t got = 0;
    do {
      got = ::waitpid(process_, &status, options);
    } while (got < 0 && errno == EINTR);
    if (got == 0) return false;
    ended_ = true;
    if (got < 0) end.exitCode = 0;  // somebody else has waited for it
    if (got > 0) end.exitCode = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return true;
  }

  void kill() {
    ProgramEnd ignored;
    ::kill(-process_, SIGTERM);
    const auto until = Clock::now() + kGrace;
    while (Clock::now() < until && !bury(WNOHANG, ignored)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ::kill(-process_, SIGKILL);
    if (!ended_) bury(0, ignored);
  }

  Pipe out_;
  Pipe err_;
  pid_t process_ = -1;
  bool ended_ = false;
  bool outOpen_ = true;
  bool errOpen_ = true;
};

void keepEnd(std::string& text) {
  if (text.size() > kMostOutput) text.erase(0, text.size() - kMostOutput);
}

}  // namespace

ProgramEnd runProgram(const std::vector<std::string>& run, std::chrono::milliseconds timeout, const std::string& doing,
                      const Progress& progress) {
  if (run.empty() || run.front().empty()) throw InvalidInput("a program is needed: the list of its arguments is empty");
  const Progress inner = progress.part(0.0, 1.0, doing);
  inner.checkpoint(0.0);
  ProgramEnd end;
  const auto start = Clock::now();
  RunningProgram program(run);
  while (!program.wait(end)) {
    const auto passed = Clock::now() - start;
    if (passed > timeout)
      throw DeviceError("the program " + run.front() + " has not ended within " +
                        argumentText(std::chrono::duration<double>(timeout).count()) +
                        " s and was stopped; see what it waits for, or give it more time (timeout_s)" + saidLast(end));
    inner.checkpoint(std::min(1.0, std::chrono::duration<double>(passed) / std::chrono::duration<double>(timeout)));
  }
  keepEnd(end.output);
  keepEnd(end.errors);
  return end;
}

std::vector<std::string> filledIn(const std::vector<std::string>& run,
                                  const std::map<std::string, std::string>& values) {
  std::vector<std::string> filled;
  for (const std::string& argument : run) {
    std::string text;
    for (std::size_t at = 0; at < argument.size();) {
      const std::size_t end = argument[at] == '{' ? argument.find('}', at) : std::string::npos;
      const std::string key = end == std::string::npos ? std::string() : argument.substr(at + 1, end - at - 1);
      const bool isWord = !key.empty() && key.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos;
      if (!isWord) {
        text += argument[at++];
        continue;
      }
      const auto value = values.find(key);
      if (value == values.end())
        throw InvalidInput("the argument '" + argument + "' has {" + key +
                           "}, which is not known here: expected {file}, {position}, {angle} or {tilt}");
      text += value->second;
      at = end + 1;
    }
    filled.push_back(std::move(text));
  }
  return filled;
}

bool names(const std::vector<std::string>& run, const std::string& key) {
  for (const std::string& argument : run)
    if (argument.find("{" + key + "}") != std::string::npos) return true;
  return false;
}

std::string saidLast(const ProgramEnd& end) {
  std::string said = end.errors.find_first_not_of(" \t\r\n") == std::string::npos ? end.output : end.errors;
  said.erase(0, std::min(said.size(), said.find_first_not_of(" \t\r\n")));
  while (!said.empty() && std::strchr(" \t\r\n", said.back()) != nullptr) said.pop_back();
  if (said.empty()) return "; it said nothing";
  if (said.size() > kMostSaid) said = "..." + said.substr(said.size() - kMostSaid);
  for (char& c : said)
    if (c == '\n' || c == '\t' || c == '\r') c = ' ';
  return "; it said: " + plainText(said);
}

std::string argumentText(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  const double rounded = std::round(value * 1e4) / 1e4;
  text << std::fixed << (rounded == 0.0 ? 0.0 : rounded);
  std::string digits = text.str();
  while (digits.ends_with('0')) digits.pop_back();
  if (digits.ends_with('.')) digits.pop_back();
  return digits;
}

}  // namespace vantage
