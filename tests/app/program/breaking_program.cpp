#include "app/program/breaking_program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "program/crash_trace.h"

namespace vantage::testing {

int endOfProgram(const std::string& name, const std::filesystem::path& folder, const std::string& session,
                 const std::function<void()>& last) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    static_cast<void>(std::freopen("/dev/null", "w", stderr));
    leaveCrashTraces(name, folder);
    nameSessionInCrashTraces("an earlier session");
    nameSessionInCrashTraces(session);
    last();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace vantage::testing
