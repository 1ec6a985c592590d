#include "cli/batch/child_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/errors.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks for it

namespace vantage {
namespace {

constexpr int kFirstOther = 3;  // descriptor behind stdin, stdout and stderr

// How the program is started; everything that posix_spawn wants.
class Settings {
 public:
  explicit Settings(const ChildProgram::Places& places) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, places.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                       0666);
    ::posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, places.errors.c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                       0666);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, kFirstOther);
    ::posix_spawn_file_actions_addchdir_np(&actions_, places.folder.c_str());
    ::posix_spawnattr_init(&attributes_);
    sigset_t signals;
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int usual : {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGXFSZ}) ::sigaddset(&signals, usual);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Settings() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  Settings(const Settings&) = delete;
  Settings& operator=(const Settings&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

ChildProgram::ChildProgram(const std::vector<std::string>& run, const Places& places) {
  std::vector<char*> arguments;
  for (const std::string& argument : run) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const Settings settings(places);
  const int failed =
      ::posix_spawn(&process_, arguments[0], settings.actions(), settings.attributes(), arguments.data(), environ);
  if (failed != 0) throw IoError(run.front(), std::string("cannot be started: ") + std::strerror(failed));
}

ChildProgram::ChildProgram(ChildProgram&& other) noexcept : process_(other.process_), exitCode_(other.exitCode_) {
  other.process_ = 0;
}

ChildProgram::~ChildProgram() {
  if (process_ == 0 || exitCode_) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<int> ChildProgram::ended() {
  int status = 0;
  if (exitCode_ || ::waitpid(process_, &status, WNOHANG) != process_) return exitCode_;
  exitCode_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return exitCode_;
}

void ChildProgram::askToEnd() const {
  if (process_ > 0 && !exitCode_) ::kill(process_, SIGTERM);
}

}  // namespace vantage
