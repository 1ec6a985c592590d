#include "io/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>

#include "base/errors.h"

namespace vantage {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kAddressSpaceIsOurs = false;  // shadow memory takes terabytes of it
#else
constexpr bool kAddressSpaceIsOurs = true;
#endif

constexpr int kPollMilliseconds = 20;
constexpr int kExitOutOfMemory = 3;

struct MemoryUse {
  std::uintmax_t total = 0;
  std::uintmax_t resident = 0;
};

MemoryUse memoryOf(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/statm");
  MemoryUse use;
  in >> use.total >> use.resident;
  const auto page = static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
  return {use.total * page, use.resident * page};
}

void setLimit(__rlimit_resource what, std::uintmax_t value) {
  const rlimit limit{value, value};
  ::setrlimit(what, &limit);
}

void sendAll(int pipe, const void* data, std::size_t bytes) {
  const char* at = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t sent = ::write(pipe, at, bytes);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) ::_exit(1);
    at += sent;
    bytes -= static_cast<std::size_t>(sent);
  }
}

// Everything the child does. It ends here: no destructor and no exit handler of ours may run in it.
[[noreturn]] void beChild(int pipe, pid_t parent, std::uintmax_t memoryBefore, const ChildLimits& limits,
                          const std::function<void(const ChildSend&)>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT}) ::signal(signal, SIG_DFL);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  setLimit(RLIMIT_CORE, 0);
  setLimit(RLIMIT_CPU, static_cast<std::uintmax_t>(std::ceil(limits.cpuSeconds)));
  if (kAddressSpaceIsOurs) setLimit(RLIMIT_AS, memoryBefore + limits.memoryBytes);
  try {
    work([pipe](const void* data, std::size_t bytes) { sendAll(pipe, data, bytes); });
  } catch (const std::bad_alloc&) {
    ::_exit(kExitOutOfMemory);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

// A running child and the reading end of its pipe. Whatever happens here, it is stopped and buried.
class Child {
 public:
  Child(pid_t process, int pipe) : process_(process), pipe_(pipe) {}
  ~Child() {
    ::close(pipe_);
    if (!buried_) {
      ::kill(process_, SIGKILL);
      bury();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Waits a little for output; false when the child has closed its end.
  bool read(std::string& output) {
    pollfd waiting{pipe_, POLLIN, 0};
    if (::poll(&waiting, 1, kPollMilliseconds) <= 0) return true;
    const ssize_t got = ::read(pipe_, buffer_.data(), buffer_.size());
    if (got < 0) return errno == EINTR;
    output.append(buffer_.data(), static_cast<std::size_t>(got));
    return got > 0;
  }

  ChildEnd bury() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    buried_ = true;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return ChildEnd::Finished;
    if (WIFEXITED(status) && WEXITSTATUS(status) == kExitOutOfMemory) return ChildEnd::OutOfMemory;
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) return ChildEnd::OutOfTime;
    return ChildEnd::Crashed;
  }

  [[nodiscard]] std::uintmax_t residentBytes() const { return memoryOf(process_).resident; }

 private:
  pid_t process_;
  int pipe_;
  bool buried_ = false;
  std::array<char, 65536> buffer_{};
};

}  // namespace

ChildResult runInChild(const std::function<void(const ChildSend&)>& work, const ChildLimits& limits,
                       const Progress& progress) {
  progress.checkpoint(0.0);
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw IoError("pipe", std::strerror(errno));
  const MemoryUse before = memoryOf(::getpid());
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) beChild(pipe[1], parent, before.total, limits, work);
  ::close(pipe[1]);
  if (process < 0) {
    ::close(pipe[0]);
    throw IoError("fork", std::strerror(errno));
  }

  Child child(process, pipe[0]);
  ChildResult result;
  const auto start = std::chrono::steady_clock::now();
  while (child.read(result.output)) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.checkpoint(std::min(1.0, elapsed / limits.wallSeconds));
    if (elapsed > limits.wallSeconds) return {ChildEnd::OutOfTime, {}};
    if (child.residentBytes() > before.resident + limits.memoryBytes) return {ChildEnd::OutOfMemory, {}};
  }
  result.end = child.bury();
  return result;
}

}  // namespace vantage
